#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "codec/bytes/bytes.h"

namespace telepalp::codec {

/// How hard zstd searches for repeated bytes (matches).
enum class ZstdEffort {
  Entropy,  ///< hardly at all: for data with few matches, such as tokens
  Matches,  ///< zstd's level 1
};

/// Appends three fields: the size of `plain`, its compressed size (0: stored uncompressed), the bytes.
void append_zstd_stream(std::string& packet, std::string_view plain, ZstdEffort effort);

/// Reads the three fields of append_zstd_stream() and decompresses the bytes. nullopt when a field is damaged, or when
/// the decompressed size, which is checked before decompression, exceeds `most_bytes`.
[[nodiscard]] std::optional<std::string> read_zstd_stream(ByteReader& reader, std::size_t most_bytes);

}  // namespace telepalp::codec
