#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "messages/recording.pb.h"
#include "proto/words/result.h"
#include "server/recording/recorder_process.h"
#include "server/recording/recording_command.h"

namespace telepalp::recording {

/// Records what a server publishes into files of one folder, one file at a time. The recorder is telepalp-record, which
/// connects to the server like any recorder, so a full disk never delays the patient's stream. Owner: the server's
/// network thread; no call blocks but the destructor.
class SessionRecorder {
 public:
  struct Options {
    std::filesystem::path folder;   ///< of the session files; it exists
    std::filesystem::path program;  ///< telepalp-record
    std::filesystem::path key;      ///< the recorder's key file; empty: the server has no keys
    std::string server;             ///< the server's address for the recorder: HOST:PORT
  };

  /// Error: the folder is not there or cannot be written to.
  [[nodiscard]] static Result<std::unique_ptr<SessionRecorder>> open(Options options);
  SessionRecorder(const SessionRecorder&) = delete;
  SessionRecorder& operator=(const SessionRecorder&) = delete;
  /// Ends a recording and waits for at most 3 s until its file is complete.
  ~SessionRecorder();

  /// Begins session_YYYYMMDD_HHMMSS.mcap, named after `now` in UTC, or lets the recorder complete its file. Error: a
  /// recording begins while one is under way, or ends while none is under way; or the recorder cannot be started.
  [[nodiscard]] Result<void> apply(const msg::RecordingCommand& command, std::chrono::system_clock::time_point now);

  /// The present state. The call also checks whether the recorder process has ended.
  [[nodiscard]] msg::RecordingState state();

 private:
  explicit SessionRecorder(Options options) : options_(std::move(options)) {}
  [[nodiscard]] Result<void> begin(const msg::RecordingCommand& command, std::chrono::system_clock::time_point now);
  void look_at_process();
  [[nodiscard]] std::filesystem::path log_file() const;

  Options options_;
  std::optional<RecorderProcess> process_;  // nullopt: no recorder runs
  std::chrono::steady_clock::time_point began_{};
  msg::RecordingState state_;
};

}  // namespace telepalp::recording
