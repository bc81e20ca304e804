#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "proto/wire/mcap/format/encoder.h"
#include "proto/wire/mcap/format/stored_message.h"
#include "proto/wire/mcap/writing/output_file.h"
#include "proto/wire/message.h"
#include "proto/words/result.h"

namespace telepalp::wire {

/// How a session file was recorded; stored in the metadata record "telepalp.session".
struct SessionInfo {
  std::string program;  ///< program that wrote the file: "telepalp-record"
  std::string version;
  std::string commit;
  std::string source;           ///< address of the recorded server ("127.0.0.1:7000"), or a file
  std::string scene;            ///< text of the scene file, or empty
  std::string recorded_by{};    ///< person or account: "doctor anna"; empty: not stated
  std::string consent{};        ///< the patient's consent, as stated to the recorder; empty: not stated
  std::string voice_consent{};  ///< the patient's consent to record speech; empty: none, so speech is left out
};
inline constexpr std::string_view kSessionMetadata = "telepalp.session";
inline constexpr std::string_view kRecordingMetadata = "telepalp.recording";  ///< results known at the recording's end

/// Parses the record "telepalp.session"; a field that the record lacks is empty.
[[nodiscard]] SessionInfo session_info(const mcap::Metadata& metadata);

/// False if the record "telepalp.session" is damaged: it states a check sum that its entries do not have. The check sum
/// is the only one that a file without its end has for this record. True for a record that states none.
[[nodiscard]] bool is_intact(const mcap::Metadata& metadata);

/// Writes a session file. Owner: one thread, which may block on the disk. While it grows, the file is called
/// NAME.partial, and every flushed chunk survives a crash. close() renames it to NAME. The destructor also closes, but
/// its errors are lost.
class McapWriter {
 public:
  [[nodiscard]] static Result<McapWriter> open(const std::filesystem::path& name, const SessionInfo& info,
                                               mcap::ChunkLimits limits = {},
                                               mcap::Protection protection = mcap::Protection::OfSite);
  McapWriter(McapWriter&&) noexcept = default;
  McapWriter& operator=(McapWriter&&) = delete;
  ~McapWriter();

  /// Writes a message. Its log time is its publishing time (0 for a time before the epoch). Its sequence number is
  /// kept, so that lost messages show as gaps; an unnumbered message gets the topic's next number. After a failed write
  /// (a full disk) each call returns the same error, and close() still completes the file with the data written before.
  [[nodiscard]] Result<void> write(const Message& message);

  /// Copies a message of any schema from another file; the ids in the records are replaced by this file's ids. The copy
  /// marks key frames, also where the other file does not.
  [[nodiscard]] Result<void> copy(const mcap::StoredMessage& message);
  [[nodiscard]] Result<void> add(const mcap::Metadata& metadata);
  [[nodiscard]] Result<void> add(const mcap::Attachment& attachment);

  /// Closes the open chunk and passes it to the operating system, so that it survives a crash of this program.
  [[nodiscard]] Result<void> flush();
  /// Writes the summary, calls fsync and renames the file to its final name.
  [[nodiscard]] Result<void> close();

  /// Ends the writing of a copy. `written`: the result of its writing. If that and all the rest is written, closes the
  /// file; otherwise removes it, so that no incomplete copy has the final name. Returns the first error.
  [[nodiscard]] Result<void> finish(Result<void> written);

  /// Removes the unfinished file.
  void discard() noexcept { file_.discard(); }

  /// Bytes written to the file so far, without the open chunk; after close(), the file's size.
  [[nodiscard]] std::uint64_t bytes() const noexcept {
    return final_bytes_ > 0 ? final_bytes_ : encoder_.committed_bytes();
  }
  [[nodiscard]] std::uint64_t messages() const noexcept { return encoder_.statistics().message_count; }
  [[nodiscard]] const std::filesystem::path& name() const noexcept { return file_.name(); }

 private:
  McapWriter(mcap::OutputFile file, mcap::ChunkLimits limits) : file_(std::move(file)), encoder_(limits) {}
  [[nodiscard]] Result<void> store();

  struct Known {
    std::uint16_t key_id = 0;        ///< id of the channel of its key frames; 0: not written yet
    std::uint16_t predicted_id = 0;  ///< likewise of its predicted messages
    std::uint32_t messages = 0;
  };
  [[nodiscard]] std::uint16_t add_channel(const mcap::Schema* schema, mcap::Channel channel);
  mcap::OutputFile file_;
  mcap::Encoder encoder_;
  std::string ready_;  // encoded bytes, not yet in the file
  std::optional<Error> failed_;
  std::uint64_t final_bytes_ = 0;
  std::map<std::string_view, Known> topics_;  // keys point to the names in wire::kTopics
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::string, std::uint16_t> channels_;  // key: the encoded channel record
};

}  // namespace telepalp::wire
