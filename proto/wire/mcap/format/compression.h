#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace telepalp::wire::mcap {

/// CRC-32 (ISO 3309, equal to zlib's) of `bytes`, continued from the CRC `before`.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0) noexcept;

/// Compresses with zstd at its fastest level, because most data in a session (depth, JPEG) is compressed already.
[[nodiscard]] std::string zstd_compress(std::string_view bytes);

/// Decompresses to exactly `size` bytes; nullopt if that fails. Allocates only `size` bytes, whatever the zstd frame
/// declares.
[[nodiscard]] std::optional<std::string> zstd_decompress(std::string_view bytes, std::size_t size);

/// As zstd_decompress(), for the frame format of lz4.
[[nodiscard]] std::optional<std::string> lz4_decompress(std::string_view bytes, std::size_t size);

}  // namespace telepalp::wire::mcap
