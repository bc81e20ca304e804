#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/format/chunk.h"
#include "proto/wire/mcap/format/record_walk.h"
#include "proto/wire/mcap/format/stored_message.h"
#include "proto/words/result.h"

namespace telepalp::wire {

/// Reads an MCAP file sequentially, in the order of writing, without its summary: for a file that was truncated or is
/// still being written. McapReader is faster and returns messages in order of time.
class McapStreamReader {
 public:
  [[nodiscard]] static Result<McapStreamReader> open(const std::filesystem::path& file);
  [[nodiscard]] static Result<McapStreamReader> open(std::unique_ptr<mcap::ByteSource> source);

  /// The next message; nullopt at the end. An error concerns one place (a chunk with a wrong CRC, bytes that are no
  /// record, or the point of truncation) and names its offset; the next call continues with the next readable chunk.
  [[nodiscard]] Result<std::optional<mcap::StoredMessage>> next();

  /// Channels read so far.
  [[nodiscard]] const mcap::ChannelTable& channels() const noexcept { return channels_; }
  [[nodiscard]] const std::vector<mcap::Metadata>& metadata() const noexcept { return metadata_; }
  [[nodiscard]] const std::vector<mcap::RecordHead>& attachments() const noexcept { return attachments_; }
  [[nodiscard]] std::uint64_t chunks() const noexcept { return chunks_; }
  /// True when the end of the data section was reached, false when the file ended before it.
  [[nodiscard]] bool complete() const noexcept { return complete_; }
  /// True when the file ended between two records or within one, as an interrupted writer leaves it.
  [[nodiscard]] bool cut_off() const noexcept { return cut_off_; }

  [[nodiscard]] Result<mcap::Attachment> read(const mcap::RecordHead& attachment);

  /// Compares all bytes of the data section with the CRC at its end. It finds what no single record shows: a changed
  /// byte in a header, in an index, or in a definition outside the chunks. Call it when next() has returned nullopt.
  /// `has_crcs`: the file's writer computes the CRCs of data and summary, as telepalp's does, so that one of them that
  /// is 0 is a damage; otherwise 0 means that it was not computed. A file whose end is missing passes.
  [[nodiscard]] Result<void> check_bytes(bool has_crcs);

 private:
  explicit McapStreamReader(std::unique_ptr<mcap::ByteSource> source) : source_(std::move(source)) {}
  [[nodiscard]] Result<bool> enter_next_record();
  [[nodiscard]] Result<void> enter_chunk(const mcap::RecordHead& head);
  [[nodiscard]] Result<std::optional<mcap::StoredMessage>> take(mcap::Opcode opcode, std::string_view content);
  [[nodiscard]] Error error_at_end() const;
  [[nodiscard]] Error skip_to_next_chunk();
  void learn_channels_from_summary();
  [[nodiscard]] Error in_chunk(const Error& error) const;

  std::unique_ptr<mcap::ByteSource> source_;
  std::uint64_t offset_ = mcap::kMagic.size();
  bool ended_ = false;
  bool complete_ = false;
  bool cut_off_ = false;
  std::optional<mcap::RecordHead> data_end_;  // the record that ends the data section
  bool summary_read_ = false;
  std::optional<std::uint64_t> summary_start_;  // nullopt: not read yet, or the file has no readable summary
  bool summary_has_crc_ = true;
  std::uint64_t chunk_offset_ = 0;                   // of the chunk read last
  std::uint64_t trusted_end_ = mcap::kMagic.size();  // where the search for a chunk begins after damage
  std::uint64_t record_offset_ = 0;                  // of the record outside chunks, or the chunk, read last
  std::uint64_t chunks_ = 0;                         // number read so far, including damaged ones
  std::unique_ptr<const std::string> records_;  // records of walk_'s chunk; on the heap, so that views survive a move
  std::optional<mcap::ChunkWalk> walk_;
  std::string content_;                  // content of the last record outside chunks
  std::optional<mcap::Opcode> waiting_;  // type of the record in content_ that is not processed yet
  mcap::ChannelTable channels_;
  std::vector<mcap::Metadata> metadata_;
  std::vector<mcap::RecordHead> attachments_;
};

}  // namespace telepalp::wire
