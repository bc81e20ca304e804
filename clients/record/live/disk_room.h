#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace telepalp::record {

/// Watches the free space on the disk of a recording.
class DiskRoom {
 public:
  explicit DiskRoom(const std::filesystem::path& file);

  /// `stored_bytes`: size of the recording until now. Returns an alarm when the disk will be full within a minute at
  /// the average rate so far, and another alarm only after the disk had space for over a minute again. Else nullopt.
  [[nodiscard]] std::optional<std::string> alarm(std::uint64_t stored_bytes);

 private:
  std::filesystem::path folder_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  bool alarmed_ = false;
};

}  // namespace telepalp::record
