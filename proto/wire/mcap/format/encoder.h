#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proto/wire/mcap/format/records.h"

namespace telepalp::wire::mcap {

/// A chunk is closed when its uncompressed records reach `bytes`, or when the log times of one channel's messages in
/// the chunk span `span_ns`. A crash loses at most the open chunk.
struct ChunkLimits {
  std::size_t bytes = std::size_t{1} << 20;
  std::uint64_t span_ns = 1'000'000'000;
};

/// Encodes messages as the bytes of an MCAP file, in memory and deterministically. Each call appends finished bytes to
/// `out`; the caller appends them to the file. After a successful write the caller calls commit(); after a failed write
/// it calls rollback(), which forgets the bytes since the last commit() and the open chunk.
class Encoder {
 public:
  explicit Encoder(ChunkLimits limits) noexcept : limits_(limits) {}

  void begin(std::string& out, const Header& header);
  /// Schemas and channels are written outside the chunks, so that a damaged chunk does not make others unreadable. The
  /// id in the record is replaced by the returned id. A channel with schema id 0 has no schema.
  std::uint16_t add(std::string& out, Schema schema);
  std::uint16_t add(std::string& out, Channel channel);
  void add(std::string& out, const MessageRecord& message);
  void add(std::string& out, const Metadata& metadata);
  void add(std::string& out, const Attachment& attachment);
  /// Closes the open chunk unless it is empty.
  void flush(std::string& out);
  /// Writes the summary and the footer; the file is then complete.
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
