#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/mcap/format/records.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Decompresses the records of a chunk, at most 64 MiB (kMaxChunkBytes), and checks the CRC. Errors do not name the
/// file. An error without `fix` means that the chunk is damaged.
[[nodiscard]] Result<std::string> unpack(const ChunkRecord& chunk);

/// Iterates over the records of a decompressed chunk, which must outlive this object.
class ChunkWalk {
 public:
  struct Entry {
    Opcode opcode{};
    std::string_view content;
  };
  explicit ChunkWalk(std::string_view records) noexcept : rest_(records) {}

  /// The next record; nullopt at the end. Error: a record type that is not allowed in a chunk (for example a nested
  /// chunk), or a record that reaches past the end; the iteration cannot continue. Errors do not name the file.
  [[nodiscard]] Result<std::optional<Entry>> next();

 private:
  std::string_view rest_;
};

}  // namespace telepalp::wire::mcap
