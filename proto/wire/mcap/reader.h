#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proto/wire/mcap/reading/summary.h"
#include "proto/wire/mcap/writer.h"

namespace telepalp::wire {

/// Selects messages by topic and time. Empty `topics`: all. A name ending in '*' is a prefix. Times are [from, until).
struct McapSelection {
  std::vector<std::string> topics = {};
  std::optional<SessionTime> from = {};
  std::optional<SessionTime> until = {};
};

/// Reads a complete session file through its index. Only chunks with selected messages are read. Messages come in order
/// of log time; of two with equal time, the one written first. Memory holds only those chunks whose time ranges contain
/// the next message's time.
class McapReader {
 public:
  /// `progress`: told how much of the index has been read.
  [[nodiscard]] static Result<McapReader> open(const std::filesystem::path& file, const mcap::Progress& progress = {});
  [[nodiscard]] static Result<McapReader> open(std::unique_ptr<mcap::ByteSource> source,
                                               const mcap::Progress& progress = {});

  [[nodiscard]] const mcap::Summary& summary() const noexcept { return summary_; }
  /// The file's metadata about its recording; a field that the file lacks is empty.
  [[nodiscard]] Result<SessionInfo> session();
  [[nodiscard]] Result<mcap::Metadata> read(const mcap::MetadataIndex& index);
  [[nodiscard]] Result<mcap::Attachment> read(const mcap::AttachmentIndex& index);

  /// Log time of the last key frame of `topic` before `at`, by the indexes of the chunks, without reading a message.
  /// nullopt: there is none, or the file is of an earlier release, which marks no key frames.
  [[nodiscard]] std::optional<SessionTime> last_key_frame(const Topic& topic, SessionTime at);

  /// Restarts at the beginning with a new selection. After open() all messages are selected.
  void select(const McapSelection& selection);

  /// The next message on one of telepalp's topics; other topics are skipped. nullopt at the end. An error concerns one
  /// chunk ("session.mcap: chunk 812: …"); the next call continues after it.
  [[nodiscard]] Result<std::optional<Message>> next();
  /// The next message on any topic.
  [[nodiscard]] Result<std::optional<mcap::StoredMessage>> next_stored();

 private:
  struct OpenChunk {
    std::string records;
    std::vector<mcap::MessageRecord> messages;  // views into `records`; the last entry is the next message
  };
  struct Next {  // orders the open chunks by their next message
    std::uint64_t log_time;
    std::size_t chunk;
    auto operator<=>(const Next&) const = default;
  };
  explicit McapReader(std::unique_ptr<mcap::ByteSource> source) : source_(std::move(source)) {}
  [[nodiscard]] bool wanted(std::size_t chunk) const;
  [[nodiscard]] Result<void> open_chunk(std::size_t chunk);
  [[nodiscard]] std::optional<std::uint64_t> last_in_chunk(const mcap::ChunkIndex& chunk, std::uint16_t channel,
                                                           std::uint64_t before);
  void learn(mcap::Opcode opcode, std::string_view content);
  [[nodiscard]] Result<void> read_record(std::uint64_t offset, std::uint64_t length, mcap::Opcode opcode,
                                         std::string& into);
  [[nodiscard]] Error in_chunk(std::size_t chunk, const char* what) const;
  [[nodiscard]] Error in_chunk(std::size_t chunk, const Error& error) const;

  std::unique_ptr<mcap::ByteSource> source_;
  mcap::Summary summary_;
  std::vector<std::string> topics_;   // selected patterns
  std::set<std::uint16_t> channels_;  // selected channel ids
  std::uint64_t from_ = 0;
  std::uint64_t last_ = UINT64_MAX;
  std::vector<std::size_t> to_open_;  // numbers of selected chunks, earliest last
  std::map<std::size_t, std::unique_ptr<OpenChunk>> open_;
  std::set<Next> order_;
  std::uint64_t open_bytes_ = 0;
  std::unique_ptr<OpenChunk> spent_;  // holds the message that was returned last
};

}  // namespace telepalp::wire
