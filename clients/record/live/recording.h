#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "clients/record/live/session_files.h"
#include "clients/record/selection/topic_filter.h"
#include "proto/keys/key_file.h"
#include "proto/wire/camera/color_message.h"
#include "proto/words/result.h"
#include "support/program/address.h"
#include "support/program/patience.h"

namespace telepalp::record {

struct RecordingOptions {
  program::Address server;
  std::shared_ptr<const keys::KeyFile> key;  ///< null: the server is on this machine
  std::filesystem::path file;
  TopicFilter topics{"*"};
  wire::ColorCoding color = wire::ColorCoding::Pictures;  ///< how /camera/color is taken, if `topics` covers it
  Splitting splitting;
  std::string consent;          ///< the patient's, as the operator states it
  std::string voice_consent;    ///< the patient's consent to record speech; empty: none, so speech is left out
  std::filesystem::path scene;  ///< scene file to attach; empty: none
  std::vector<std::filesystem::path> attachments;  ///< other files to attach
  std::chrono::duration<double> seconds{0.0};      ///< duration from the first connection; 0: until a signal
  program::Patience patience;                      ///< time limit of the first connection
  std::filesystem::path ready_file;                ///< created once the recorder has subscribed; empty: none
  bool progress = false;                           ///< show a progress line on stderr
};

/// Result of a successful recording.
struct RecordingReport {
  std::uint64_t messages = 0;
  std::uint64_t file_bytes = 0;
  double seconds = 0.0;  ///< since the first connection
  std::uint64_t files = 1;
  bool in_parts = false;      ///< the files' names have a number, even if there is one file only
  std::uint64_t dropped = 0;  ///< messages dropped because the disk was too slow, full or failing
  std::uint64_t gaps = 0;     ///< number of times that the connection was lost
  double gap_s = 0.0;         ///< total time without a connection
};

/// Subscribes and writes the received messages until the time is up or SIGINT or SIGTERM arrives. The files are then
/// complete and indexed; after an error, too, if the server had answered before. A full disk is logged and does not end
/// the recording: it goes on in a new file when there is space again, and its result is an error. Further signals have
/// no effect. Five seconds after the first signal the process ends, even if the disk has not stored everything.
[[nodiscard]] Result<RecordingReport> record(const RecordingOptions& options);

/// The report as text: "12.0 s from connecting to the server to the end of the recording, 3210 messages, …".
[[nodiscard]] std::string describe(const RecordingReport& report);

}  // namespace telepalp::record
