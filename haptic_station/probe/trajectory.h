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
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();  ///< may be NaN: answered without force
};

/// Reads `t_s,x,y,z` lines, with or without that header line. Time that goes back or is not a number is an error with
/// its line; a position that is not a number is kept, for the touch to answer safely.
[[nodiscard]] Result<std::vector<Waypoint>> read_trajectory(const std::filesystem::path& file);
[[nodiscard]] Result<std::vector<Waypoint>> parse_trajectory(std::string_view text, const std::string& name);

}  // namespace telepalp::probe
