#pragma once

#include <optional>
#include <vector>

#include "haptic_station/probe/trajectory.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::probe {

/// Parameters of a palpation path: at each of several spots (surface points) the hand presses in, moves in a circle at
/// constant depth, and withdraws; then it moves to the next spot.
struct PalpationSettings {
  int spots = 5;
  double apart_m = 0.03;  ///< least distance between spots
  double depth_m = 0.01;  ///< depth below the surface
  double above_m = 0.03;  ///< height above the surface at which each press begins and ends
  double speed_m_per_s = 0.1;
  double rate_hz = 2000.0;
  std::optional<Eigen::Vector3d> at_m =
      std::nullopt;  ///< the first spot is the candidate nearest to this point; nullopt: to the candidates' median
};

/// Makes a path over `snapshot`, in its frame. `on_surface`: surface points, the candidates for spots. Each spot's
/// normal is within 45 degrees of the first spot's, so that the path between spots stays above the surface. The path
/// has fewer spots if fewer candidates are suitable. Error: no candidate has surface all around it.
[[nodiscard]] Result<std::vector<Waypoint>> palpation_path(const surface::SurfaceSnapshot& snapshot,
                                                           const std::vector<Eigen::Vector3d>& on_surface,
                                                           const PalpationSettings& settings);

/// Writes the path as a CSV file that read_trajectory() reads.
[[nodiscard]] Result<void> write_trajectory(const std::filesystem::path& file, const std::vector<Waypoint>& path);

}  // namespace telepalp::probe
