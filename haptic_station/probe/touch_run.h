#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "haptic_station/probe/trajectory.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::probe {

/// What was felt at one waypoint, in the cloud's frame.
struct Felt {
  double t_s = 0.0;
  Eigen::Vector3d proxy_m = Eigen::Vector3d::Zero();  ///< the device itself while not in contact
  double distance_m = 0.0;                            ///< of the device from the surface; NaN: no surface in reach
  bool in_body = false;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< zero: no surface in reach
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  double step_us = 0.0;
};

/// Touches every waypoint in turn, at the trajectory's own times. A waypoint that is not a number is answered at the
/// last place that was one, without force. A jump is swept through what lies between, up to the surface; one of more
/// than half a metre lets go of what was held, and touches anew where it ends.
[[nodiscard]] std::vector<Felt> touch_along(const surface::SurfaceSnapshot& snapshot,
                                            const std::vector<Waypoint>& trajectory, double stiffness_N_per_m);

/// Columns t_s,px,py,pz,distance_m,in_body,nx,ny,nz,fx,fy,fz,step_us. The file appears when it is whole.
[[nodiscard]] Result<void> write_felt(const std::filesystem::path& file, const std::vector<Felt>& felt);

}  // namespace telepalp::probe
