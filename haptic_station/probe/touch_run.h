#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "haptic_station/probe/trajectory.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::probe {

/// Contact and force at one waypoint, in the snapshot's frame.
struct Felt {
  double t_s = 0.0;
  Eigen::Vector3d proxy_m = Eigen::Vector3d::Zero();  ///< equals the waypoint while not in contact
  double distance_m = 0.0;  ///< waypoint's signed distance from the surface; NaN: no surface in reach
  bool in_body = false;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< zero: no surface in reach
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  double step_us = 0.0;  ///< computing time
};

/// Touches the waypoints in order, at their times. The force is `stiffness_N_per_m` times the vector from
/// waypoint to proxy. A NaN waypoint repeats the last finite position, without force. A jump of at most 0.5 m is swept,
/// so that a surface between both waypoints stops the proxy; a longer jump ends the contact and starts a new one.
[[nodiscard]] std::vector<Felt> touch_along(const surface::SurfaceSnapshot& snapshot,
                                            const std::vector<Waypoint>& trajectory, double stiffness_N_per_m);

/// A summary for the terminal: waypoints, contacts, the largest force and the computing time. If the surface ended, a
/// second line counts the waypoints without a surface in reach, where nothing is felt.
[[nodiscard]] std::string in_words(const std::vector<Felt>& felt);

/// Writes a CSV file, atomically, with the columns t_s,px,py,pz,distance_m,in_body,nx,ny,nz,fx,fy,fz,step_us.
[[nodiscard]] Result<void> write_felt(const std::filesystem::path& file, const std::vector<Felt>& felt);

}  // namespace telepalp::probe
