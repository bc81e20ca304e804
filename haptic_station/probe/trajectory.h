#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::probe {

struct Waypoint {
  double t_s = 0.0;
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();  ///< in the surface's frame; NaN: touch_along() gives no force
};

/// Reads lines `t_s,x,y,z` (seconds, metres), with or without this text as header line. Error: a line without four
/// columns, or a time that decreases or is not finite, each reported with its line number; no waypoint, or more than
/// 20 million. A position that is not a number is kept as NaN, to test that touch_along() survives it.
[[nodiscard]] Result<std::vector<Waypoint>> read_trajectory(const std::filesystem::path& file);
[[nodiscard]] Result<std::vector<Waypoint>> parse_trajectory(std::string_view text, const std::string& name);

}  // namespace telepalp::probe
