#pragma once

#include <cstdint>
#include <optional>

#include "proto/wire/mcap/format/byte_source.h"

namespace telepalp::wire::mcap {

/// Offset of the first chunk at or after `from`: a record head and chunk header whose sizes agree with each other and
/// with the file. nullopt: none, or an I/O error. Reads at most 1 MiB at a time and skips the holes of a sparse file.
[[nodiscard]] std::optional<std::uint64_t> find_chunk(ByteSource& source, std::uint64_t from);

/// True if the file ends at `offset`, or within the record that begins there: what an interrupted writer leaves. False
/// if the bytes at `offset` begin no record, or if the sizes in a chunk's head contradict each other.
[[nodiscard]] bool ends_within_record(ByteSource& source, std::uint64_t offset);

}  // namespace telepalp::wire::mcap
