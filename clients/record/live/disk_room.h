#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace telepalp::record {

/// Watches the room on the disk of a recording.
class DiskRoom {
 public:
  explicit DiskRoom(const std::filesystem::path& file);

  /// `stored_bytes`: size of the recording until now. Returns an alarm when the disk will be full within a minute at
  /// the average rate so far. It returns another alarm only if there was room for over a minute in between.
  [[nodiscard]] std::optional<std::string> alarm(std::uint64_t stored_bytes);

 private:
  std::filesystem::path folder_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  bool alarmed_ = false;
};

}  // namespace telepalp::record
