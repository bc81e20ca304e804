#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/mcap/format/records.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// The records of a chunk, unpacked and checked against its CRC; at most kMaxChunkBytes. Errors name no
/// file; one without a fix is a damage.
[[nodiscard]] Result<std::string> unpack(const ChunkRecord& chunk);

/// Goes through the records of an unpacked chunk, which must outlive it.
class ChunkWalk {
 public:
  struct Entry {
    Opcode opcode{};
    std::string_view content;
  };
  explicit ChunkWalk(std::string_view records) noexcept : rest_(records) {}

  /// nullopt at the end. A record that may not stand in a chunk (another chunk above all) or reaches past the end
  /// is an error, after which there is no going on. Errors name no file.
  [[nodiscard]] Result<std::optional<Entry>> next();

 private:
  std::string_view rest_;
};

}  // namespace telepalp::wire::mcap
