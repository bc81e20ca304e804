#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "codec/bytes/bytes.h"

namespace telepalp::codec {

/// How much effort zstd spends on matches.
enum class ZstdEffort {
  Entropy,  ///< entropy coding only: tokens hardly repeat
  Matches,  ///< zstd's level 1
};

/// Appends `plain` as: its size, its compressed size (0: stored uncompressed), the bytes.
void append_zstd_stream(std::string& packet, std::string_view plain, ZstdEffort effort);

/// Reads one such stream. nullopt when it is damaged, or longer than `most_bytes`, which is checked first.
[[nodiscard]] std::optional<std::string> read_zstd_stream(ByteReader& reader, std::size_t most_bytes);

}  // namespace telepalp::codec
