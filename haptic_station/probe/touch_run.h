#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "haptic_station/probe/trajectory.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::probe {

/// Contact and force at one waypoint, in the cloud's frame.
struct Felt {
  double t_s = 0.0;
  Eigen::Vector3d proxy_m = Eigen::Vector3d::Zero();  ///< equals the waypoint while not in contact
  double distance_m = 0.0;  ///< waypoint's signed distance from the surface; NaN: none in reach
  bool in_body = false;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< zero: no surface in reach
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  double step_us = 0.0;  ///< computing time
};

/// Touches the waypoints in order, at the times of the trajectory. A waypoint that is NaN repeats the last finite
/// position, without force. A jump of at most 0.5 m is swept for a surface in between; a longer jump ends the contact
/// and starts a new one.
[[nodiscard]] std::vector<Felt> touch_along(const surface::SurfaceSnapshot& snapshot,
                                            const std::vector<Waypoint>& trajectory, double stiffness_N_per_m);

/// Columns t_s,px,py,pz,distance_m,in_body,nx,ny,nz,fx,fy,fz,step_us. The file is written atomically.
[[nodiscard]] Result<void> write_felt(const std::filesystem::path& file, const std::vector<Felt>& felt);

}  // namespace telepalp::probe
