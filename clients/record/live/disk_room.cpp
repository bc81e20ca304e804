#include "clients/record/live/disk_room.h"

#include <system_error>
#include <utility>

namespace telepalp::record {

namespace {

/// Absolute where possible, so that the alarm names the disk.
std::filesystem::path whole_folder_of(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::filesystem::path whole = std::filesystem::absolute(file, unknown);
  return unknown ? std::filesystem::path(".") : whole.parent_path();
}

}  // namespace

DiskRoom::DiskRoom(const std::filesystem::path& file) : folder_(whole_folder_of(file)) {}

std::optional<std::string> DiskRoom::alarm(std::uint64_t stored_bytes) {
  constexpr double kShort_s = 60.0;
  constexpr double kLeast_s = 2.0;  // before that, the rate is not known
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  std::error_code unknown;
  const auto room = std::filesystem::space(folder_, unknown);
  if (unknown || seconds < kLeast_s || stored_bytes == 0) return std::nullopt;
  const double left_s = static_cast<double>(room.available) * seconds / static_cast<double>(stored_bytes);
  const bool was_alarmed = std::exchange(alarmed_, left_s < kShort_s);
  if (!alarmed_ || was_alarmed) return std::nullopt;
  return "ALARM: the disk of the recording has room for only " + std::to_string(static_cast<int>(left_s)) +
         " s more. fix: delete or move files on the disk of " + folder_.string();
}

}  // namespace telepalp::record
