#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proto/wire/mcap/writer.h"
#include "proto/wire/message.h"
#include "proto/words/result.h"
#include "support/speech/speech_survey.h"

namespace telepalp::record {

/// When a recording begins a new file, and which files it keeps.
struct Splitting {
  std::optional<std::uint64_t> bytes;    ///< at this size, a file ends at the next key frame, or 2 s later
  std::optional<Nanoseconds> time;       ///< likewise at this duration of the file
  std::optional<Nanoseconds> keep_last;  ///< files last a tenth of this, at least 1 s; removed when their end is older

  [[nodiscard]] bool in_parts() const noexcept { return bytes || time || keep_last; }
};

/// The file of part `number`, from 1, of a recording in parts: session.0001.mcap for the name session.mcap.
[[nodiscard]] std::filesystem::path part_file(const std::filesystem::path& name, int number);

/// The files of one recording: one file, or parts NAME.0001.mcap, NAME.0002.mcap, … Each part is a complete session. A
/// later part begins with the last message of each latched topic (such as camera model and status) and with a key frame
/// of depth, unless none comes within 2 s. A part with speech ends with a record of where people speak
/// (speech::speech_record()). When a write fails, the part is completed with the messages that it holds.
/// Messages are then dropped and counted until a new part begins, for which 256 MiB of the disk must be free. Owner:
/// the disk thread, except where a comment says otherwise.
class SessionFiles {
 public:
  struct Plan {
    std::filesystem::path name;
    wire::SessionInfo session;
    std::vector<wire::mcap::Attachment> attachments;
    Splitting splitting;
  };
  using Alarm = std::function<void(const std::string&)>;

  /// `alarm` is called on the disk thread. Error: the first file cannot be created.
  [[nodiscard]] static Result<std::unique_ptr<SessionFiles>> open(Plan plan, Alarm alarm);

  void write(const wire::Message& message);
  /// Passes all messages to the operating system, so that they survive the end of this process.
  void flush();
  /// Completes the last part with `notes`. Call it when the disk thread has ended. Error: messages were lost because
  /// the disk failed or was full, or the last part could not be completed.
  [[nodiscard]] Result<void> close(const wire::mcap::Metadata& notes);
  /// Removes the only file. Call it instead of close() when the server never answered.
  void discard();

  struct Counts {
    std::uint64_t messages = 0;  ///< in the parts that were not removed
    std::uint64_t bytes = 0;     ///< size of the completed parts that were not removed
    std::vector<std::filesystem::path> files;
  };
  [[nodiscard]] Counts counts() const;
  /// Messages dropped because the disk failed or was full, or while needs_key_frame() was true. Any thread.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }
  /// True while, after a failure, a new part waits for a key frame, and messages are dropped. Any thread.
  [[nodiscard]] bool needs_key_frame() const noexcept { return needs_key_frame_; }

 private:
  struct Part {
    std::filesystem::path file;
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;
    SessionTime end;
  };
  SessionFiles(Plan plan, Alarm alarm) : plan_(std::move(plan)), alarm_(std::move(alarm)) {}
  [[nodiscard]] std::filesystem::path next_name();
  [[nodiscard]] Result<void> begin_part();
  [[nodiscard]] Result<void> end_part(const wire::mcap::Metadata* notes);
  [[nodiscard]] bool tells_now(const wire::Message& message) const;
  void put(const wire::Message& published);
  void put_held_back();
  [[nodiscard]] bool is_full(const wire::Message& message) const;
  void go_on_in_new_part(const wire::Message& message);
  void remove_old_parts(SessionTime now);
  void fail(const Error& error);
  [[nodiscard]] bool may_try_again() const;

  Plan plan_;
  Alarm alarm_;
  std::optional<wire::McapWriter> writer_;  // nullopt: the disk has failed
  speech::SpeechSurvey speech_;             // of the present part
  std::deque<Part> parts_;                  // completed
  std::map<std::string_view, wire::Message> latched_;
  /// The first message of each latched topic, perhaps hours old, until any newer message arrives. nullopt: written.
  std::optional<std::vector<wire::Message>> held_back_{std::in_place};
  int part_number_ = 0;
  std::uint64_t offered_to_part_ = 0;  // messages given to the part; those of its last chunk are lost if the disk fails
  std::optional<SessionTime> part_began_;     // time of the part's first message
  std::optional<SessionTime> waiting_since_;  // when a new part became due; it waits for a key frame
  SessionTime newest_{};
  std::optional<Error> failed_;  // the first failure
  bool has_groups_ = false;      // without a topic that may be predicted, no part waits for a key frame
  /// Topic of the first predicted message; a part begins with a key frame of it. Empty: all messages were key frames.
  std::string_view predicted_topic_;
  bool is_failing_ = false;
  std::chrono::steady_clock::time_point failed_at_{};
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<bool> needs_key_frame_{false};
};

}  // namespace telepalp::record
