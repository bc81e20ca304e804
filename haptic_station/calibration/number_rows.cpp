#include "haptic_station/calibration/number_rows.h"

#include <fstream>
#include <sstream>

namespace telepalp::calibration {

Result<std::string> read_rows(const std::filesystem::path& file) {
  constexpr std::uintmax_t kMostBytes = 16u << 20;
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMostBytes)
    return Error{.what = "is larger than 16 MiB", .where = file.string(), .fix = "give fewer rows"};
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return text.str();
}

}  // namespace telepalp::calibration
