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

/// Reads an MCAP file from front to back, in the order written, without needing its summary: for a file that was
/// cut off, or is being written. McapReader is quicker and in order of time.
class McapStreamReader {
 public:
  [[nodiscard]] static Result<McapStreamReader> open(const std::filesystem::path& file);
  [[nodiscard]] static Result<McapStreamReader> open(std::unique_ptr<mcap::ByteSource> source);

  /// The next message; nullopt at the end. An error speaks of one place (a chunk whose CRC does not match, the
  /// point where the file was cut off); asking again goes on behind it, as far as there is a way on.
  [[nodiscard]] Result<std::optional<mcap::StoredMessage>> next();

  /// What has been met so far.
  [[nodiscard]] const mcap::ChannelTable& channels() const noexcept { return channels_; }
  [[nodiscard]] const std::vector<mcap::Metadata>& metadata() const noexcept { return metadata_; }
  [[nodiscard]] const std::vector<mcap::RecordHead>& attachments() const noexcept { return attachments_; }
  [[nodiscard]] std::uint64_t chunks() const noexcept { return chunks_; }
  /// The data's end was reached, rather than the file's.
  [[nodiscard]] bool complete() const noexcept { return complete_; }

  [[nodiscard]] Result<mcap::Attachment> read(const mcap::RecordHead& attachment);

 private:
  explicit McapStreamReader(std::unique_ptr<mcap::ByteSource> source) : source_(std::move(source)) {}
  [[nodiscard]] Result<bool> enter_next_record();
  [[nodiscard]] Result<void> enter_chunk(const mcap::RecordHead& head);
  [[nodiscard]] Result<std::optional<mcap::StoredMessage>> take(mcap::Opcode opcode, std::string_view content);
  [[nodiscard]] Error cut_off() const;
  [[nodiscard]] Error in_chunk(const Error& error) const;

  std::unique_ptr<mcap::ByteSource> source_;
  std::uint64_t offset_ = mcap::kMagic.size();
  bool ended_ = false;
  bool complete_ = false;
  std::uint64_t chunks_ = 0;                    // entered so far, the damaged among them
  std::unique_ptr<const std::string> records_;  // of the chunk that walk_ is in; on the heap, so that a move keeps it
  std::optional<mcap::ChunkWalk> walk_;
  std::string content_;                  // of the record outside of chunks that was read last
  std::optional<mcap::Opcode> waiting_;  // content_ is to be taken
  mcap::ChannelTable channels_;
  std::vector<mcap::Metadata> metadata_;
  std::vector<mcap::RecordHead> attachments_;
};

}  // namespace telepalp::wire
