#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proto/wire/mcap/format/records.h"

namespace telepalp::wire::mcap {

/// When a chunk is closed: at this size, or when one channel's messages in it span this time, whichever is first.
/// What is in an open chunk is what a crash may lose.
struct ChunkLimits {
  std::size_t bytes = std::size_t{1} << 20;
  std::uint64_t span_ns = 1'000'000'000;
};

/// Turns messages into the bytes of an MCAP file, in memory: the same input gives the same bytes. Each call appends
/// what is ready to `out`; its bytes belong at the file's end. Knows nothing of files but that a write can fail:
/// commit() after bytes are safe, rollback() when those since the last commit are not.
class Encoder {
 public:
  explicit Encoder(ChunkLimits limits) noexcept : limits_(limits) {}

  void begin(std::string& out, const Header& header);
  /// Schemas and channels stand outside the chunks, so that one damaged chunk never hides what the others mean.
  /// The id in the record is replaced by the one returned; a schema id of 0 in a channel means none.
  std::uint16_t add(std::string& out, Schema schema);
  std::uint16_t add(std::string& out, Channel channel);
  void add(std::string& out, const MessageRecord& message);
  void add(std::string& out, const Metadata& metadata);
  void add(std::string& out, const Attachment& attachment);
  /// Closes the open chunk, if it holds anything.
  void flush(std::string& out);
  /// The summary and the footer. The file is complete after it.
  void end(std::string& out);

  void commit();
  void rollback();

  [[nodiscard]] std::uint64_t committed_bytes() const noexcept { return committed_.bytes; }
  [[nodiscard]] const Statistics& statistics() const noexcept { return now_.statistics; }

 private:
  struct OpenChunk {
    std::string records;
    std::uint64_t start = UINT64_MAX;
    std::uint64_t end = 0;
    std::map<std::uint16_t, MessageIndex> indexes;
  };
  struct Progress {
    std::uint64_t bytes = 0;
    std::uint32_t data_crc = 0;
    std::size_t chunks = 0;
    std::size_t attachments = 0;
    std::size_t metadata = 0;
    Statistics statistics;
  };
  void written(std::string_view bytes);
  void count(const OpenChunk& chunk);

  ChunkLimits limits_;
  OpenChunk open_;
  Progress now_;
  Progress committed_;
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::vector<ChunkIndex> chunk_indexes_;
  std::vector<AttachmentIndex> attachment_indexes_;
  std::vector<MetadataIndex> metadata_indexes_;
};

}  // namespace telepalp::wire::mcap
