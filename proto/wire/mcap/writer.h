#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "proto/wire/mcap/format/encoder.h"
#include "proto/wire/mcap/writing/output_file.h"
#include "proto/wire/message.h"
#include "proto/words/result.h"

namespace telepalp::wire {

/// What a session file says of its making: the metadata record "telepalp.session".
struct SessionInfo {
  std::string program;  ///< "telepalp-record"
  std::string version;
  std::string commit;
  std::string source;  ///< what was recorded: "127.0.0.1:7000", or a file
  std::string scene;   ///< text of the scene file, or empty
};
inline constexpr std::string_view kSessionMetadata = "telepalp.session";
inline constexpr std::string_view kRecordingMetadata =
    "telepalp.recording";  ///< what the recorder found out by its end

/// Reads that record; empty texts where it says nothing.
[[nodiscard]] SessionInfo session_info(const mcap::Metadata& metadata);

/// Writes a session file. Owner: one thread, which may block on the disk. The file grows as NAME.partial, in which
/// every flushed chunk survives a crash, and gets its name at close(). Leaving scope closes too, errors unseen.
class McapWriter {
 public:
  [[nodiscard]] static Result<McapWriter> open(const std::filesystem::path& name, const SessionInfo& info,
                                               mcap::ChunkLimits limits = {});
  McapWriter(McapWriter&&) noexcept = default;
  McapWriter& operator=(McapWriter&&) = delete;
  ~McapWriter();

  /// Logged at the time it was published (a time before the epoch as 0), with its sequence number, so that a loss
  /// on the way shows as a gap; one that is not numbered gets the next of its topic. After a failed write (a full
  /// disk) the same error comes again, and close() still makes a whole file of what was safe.
  [[nodiscard]] Result<void> write(const Message& message);

  /// A message of any schema, as another file holds it; the ids in the records are replaced by this file's.
  /// `schema` null: the channel has none.
  [[nodiscard]] Result<void> copy(const mcap::Schema* schema, const mcap::Channel& channel,
                                  const mcap::MessageRecord& message);
  [[nodiscard]] Result<void> add(const mcap::Metadata& metadata);
  [[nodiscard]] Result<void> add(const mcap::Attachment& attachment);

  /// Hands the open chunk to the operating system, so that a crash of this program cannot lose it.
  [[nodiscard]] Result<void> flush();
  /// Summary, fsync, final name.
  [[nodiscard]] Result<void> close();

  /// Removes the file: there was nothing to write.
  void discard() noexcept { file_.discard(); }

  /// Bytes and messages in finished chunks; after close(), in all.
  [[nodiscard]] std::uint64_t bytes() const noexcept {
    return final_bytes_ > 0 ? final_bytes_ : encoder_.committed_bytes();
  }
  [[nodiscard]] std::uint64_t messages() const noexcept { return encoder_.statistics().message_count; }
  [[nodiscard]] const std::filesystem::path& name() const noexcept { return file_.name(); }

 private:
  McapWriter(mcap::OutputFile file, mcap::ChunkLimits limits) : file_(std::move(file)), encoder_(limits) {}
  [[nodiscard]] Result<void> store();

  struct Known {
    std::uint16_t id = 0;
    std::uint32_t messages = 0;
  };
  mcap::OutputFile file_;
  mcap::Encoder encoder_;
  std::string ready_;  // encoded, not yet in the file
  std::optional<Error> failed_;
  std::uint64_t final_bytes_ = 0;
  std::map<std::string_view, Known> topics_;  // keys live in wire::kTopics
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::string, std::uint16_t> copied_channels_;  // by the channel's own bytes
};

}  // namespace telepalp::wire
