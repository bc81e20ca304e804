#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/format/record_walk.h"
#include "proto/wire/mcap/format/stored_message.h"

namespace telepalp::wire::mcap {

/// The summary section at the end of a complete file. read_summary() has checked that the chunks, attachments and
/// metadata which the indexes name lie in the data section.
struct Summary {
  std::uint64_t start = 0;  ///< its first byte in the file, behind the record that ends the data section
  bool has_crc = false;     ///< false: its writer computed none
  ChannelTable channels;
  Statistics statistics;
  std::vector<ChunkIndex> chunks;  ///< in file order
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
};

/// Told of the share of the summary that has been read, 0 to 1.
using Progress = std::function<void(double share)>;

/// Finds, checks (CRC, bounds) and reads the summary. Error: no summary, a damaged one, or messages without an index.
[[nodiscard]] Result<Summary> read_summary(ByteSource& source, const Progress& progress = {});

}  // namespace telepalp::wire::mcap
