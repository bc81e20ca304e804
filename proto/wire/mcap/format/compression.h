#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace telepalp::wire::mcap {

/// CRC-32 (ISO 3309, as zlib's) of `bytes`, continuing from `before`.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0) noexcept;

/// zstd at its quickest level: what fills a session is compressed already by its codecs.
[[nodiscard]] std::string zstd_compress(std::string_view bytes);

/// Exactly `size` bytes, or nullopt. Allocates `size` and no more, whatever the frame declares.
[[nodiscard]] std::optional<std::string> zstd_decompress(std::string_view bytes, std::size_t size);

}  // namespace telepalp::wire::mcap
