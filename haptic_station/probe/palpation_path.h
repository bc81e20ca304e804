#pragma once

#include <optional>
#include <vector>

#include "haptic_station/probe/trajectory.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::probe {

/// Parameters of a palpation path: at each of several spots the hand presses, circles at depth, withdraws, and moves
/// on.
struct PalpationSettings {
  int spots = 5;
  double apart_m = 0.03;    ///< least distance between spots
  double within_m = 0.12;   ///< largest distance of a spot from the first one
  double depth_m = 0.01;    ///< depth below the surface
  double above_m = 0.03;    ///< height above the surface at which a press begins and ends
  double circle_m = 0.005;  ///< radius of the circle at depth
  double speed_m_per_s = 0.1;
  double rate_hz = 2000.0;
  std::optional<Eigen::Vector3d> at_m =
      std::nullopt;  ///< the first spot is the surface point nearest to this; nullopt: to the cloud's middle
};

/// Makes a path over `snapshot`. `on_surface`: points on it, the candidates for spots. All spots have normals similar
/// to the first spot's, so that the path between them stays above the surface. Error: no point is surrounded by surface
/// on all sides.
[[nodiscard]] Result<std::vector<Waypoint>> palpation_path(const surface::SurfaceSnapshot& snapshot,
                                                           const std::vector<Eigen::Vector3d>& on_surface,
                                                           const PalpationSettings& settings);

/// Writes the path as a CSV file that read_trajectory() reads.
[[nodiscard]] Result<void> write_trajectory(const std::filesystem::path& file, const std::vector<Waypoint>& path);

}  // namespace telepalp::probe
