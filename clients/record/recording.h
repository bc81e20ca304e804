#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "support/program/address.h"
#include "support/program/patience.h"

namespace telepalp::record {

struct RecordingOptions {
  program::Address server;
  std::filesystem::path file;
  std::vector<std::string> topics;
  std::chrono::duration<double> seconds{0.0};  ///< from the first connection on; 0: until it is stopped
  program::Patience patience;                  ///< for the first connection
  std::filesystem::path ready_file;            ///< written when the server is subscribed to
  bool progress = false;                       ///< draw a line on stderr that follows the recording
};

/// What became of a recording that ended as it should.
struct RecordingReport {
  std::uint64_t messages = 0;
  std::uint64_t file_bytes = 0;
  double seconds = 0.0;       ///< since the first connection
  std::uint64_t dropped = 0;  ///< because the disk did not keep up
  std::uint64_t gaps = 0;     ///< times that the server was away
  double gap_s = 0.0;
};

/// Subscribes and writes what comes, until the time is up or SIGINT or SIGTERM arrives. The file is complete and
/// indexed then, and also if it fails on the way, as far as anything was received. Further signals change nothing; five
/// seconds after the first one the process ends even if the disk has not taken the rest.
[[nodiscard]] Result<RecordingReport> record(const RecordingOptions& options);

/// "12.0 s, 3210 messages, 4.5 MB"
[[nodiscard]] std::string describe(const RecordingReport& report);

}  // namespace telepalp::record
