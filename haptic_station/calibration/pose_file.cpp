#include "haptic_station/calibration/pose_file.h"

#include <Eigen/Geometry>
#include <string>

#include "haptic_station/calibration/number_rows.h"
#include "proto/words/numbers/number_row.h"
#include "proto/words/rotation_vector.h"

namespace telepalp::calibration {
namespace {

constexpr std::size_t kMostPoses = 10'000;

Eigen::Isometry3d pose_of(const double* six) { return isometry_of({six[3], six[4], six[5]}, {six[0], six[1], six[2]}); }

}  // namespace

std::optional<Eigen::Isometry3d> parse_pose(std::string_view text) {
  const auto six = number_row<6>(text);
  return six ? std::optional(pose_of(six->data())) : std::nullopt;
}

Result<std::vector<HandOnProbe>> parse_hand_on_probe(std::string_view text, std::string_view name) {
  const std::string file(name);
  if (take_line(text) != kPoseHeader)
    return Error{.what = "the first row is not the header",
                 .where = file + ":1",
                 .fix = "write this first row: " + std::string(kPoseHeader)};
  std::vector<HandOnProbe> poses;
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    const auto row = number_row<12>(line);
    if (!row || poses.size() == kMostPoses)
      return Error{.what = row ? "the file has more than 10000 rows" : "the row is not twelve finite numbers",
                   .where = file + ":" + std::to_string(number),
                   .fix = row ? "give at most 10000 rows"
                              : "give x, y, z in metres and a rotation vector in radians, of hand and probe"};
    poses.push_back({.tracker_from_hand = pose_of(row->data()), .haptic_from_probe = pose_of(row->data() + 6)});
  }
  return poses;
}

Result<std::vector<HandOnProbe>> read_hand_on_probe(const std::filesystem::path& file) {
  const Result<std::string> text = read_rows(file);
  if (!text) return text.error();
  return parse_hand_on_probe(*text, file.string());
}

}  // namespace telepalp::calibration
