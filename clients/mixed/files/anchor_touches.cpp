#include "clients/mixed/files/anchor_touches.h"

#include <cmath>

#include "clients/mixed/files/tables.h"
#include "proto/words/numbers/number_row.h"

namespace telepalp::mixed {

Result<AnchorTouches> read_touches(const std::filesystem::path& file) {
  constexpr double kMostPlaces = 1000.0;
  AnchorTouches touches;
  const Result<void> read = each_row(file, kTouchesHeader, [&](std::string_view row) {
    const auto n = number_row<10>(row);
    if (!n || (*n)[0] != std::round((*n)[0]) || (*n)[0] < -1.0 || (*n)[0] > kMostPlaces) return false;
    const Eigen::Isometry3d headset_from_tool = pose_at(*n, 4);
    if ((*n)[0] < 0.0)
      touches.pivot.push_back(headset_from_tool);
    else
      touches.places.push_back({static_cast<int>((*n)[0]), {vector_at(*n, 1)}, headset_from_tool});
    return true;
  });
  if (!read) return read.error();
  return touches;
}

std::string touches_table(const AnchorTouches& touches) {
  std::string text = std::string(kTouchesHeader) + "\n";
  const auto add = [&](int place, const Eigen::Vector3d& known, const Eigen::Isometry3d& headset_from_tool) {
    std::vector<double> row{1.0 * place, known.x(), known.y(), known.z()};
    for (const double number : pose_numbers(headset_from_tool)) row.push_back(number);
    text += cells(row) + "\n";
  };
  for (const Eigen::Isometry3d& turned : touches.pivot) add(-1, Eigen::Vector3d::Zero(), turned);
  for (const AnchorTouches::AtPlace& one : touches.places) add(one.place, one.known.m, one.headset_from_tool);
  return text;
}

std::string anchor_table(const HeadsetAnchor& anchor) {
  std::vector<double> row = pose_numbers(anchor.headset_from_haptic.iso);
  row.push_back(anchor.rms_m);
  return std::string(kAnchorHeader) + "\n" + cells(row) + "\n";
}

}  // namespace telepalp::mixed
