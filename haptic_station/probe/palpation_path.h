#pragma once

#include <optional>
#include <vector>

#include "haptic_station/probe/trajectory.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::probe {

/// How a hand palpates: presses at some spots, circles at depth, leaves, and goes on to the next.
struct PalpationSettings {
  int spots = 5;
  double apart_m = 0.03;    ///< least distance between spots
  double within_m = 0.12;   ///< of the first spot
  double depth_m = 0.01;    ///< below the surface
  double above_m = 0.03;    ///< where a press begins and ends
  double circle_m = 0.005;  ///< radius of the circle at depth
  double speed_m_per_s = 0.1;
  double rate_hz = 2000.0;
  std::optional<Eigen::Vector3d> at_m =
      std::nullopt;  ///< the first spot is the point nearest to it; none: to the cloud's middle
};

/// A path over `snapshot`, from points that are known to lie on it. Spots look about the same way as the first, so that
/// the way between them leads over the surface. An error when no point has whole surface around it.
[[nodiscard]] Result<std::vector<Waypoint>> palpation_path(const surface::SurfaceSnapshot& snapshot,
                                                           const std::vector<Eigen::Vector3d>& on_surface,
                                                           const PalpationSettings& settings);

/// As CSV that read_trajectory reads.
[[nodiscard]] Result<void> write_trajectory(const std::filesystem::path& file, const std::vector<Waypoint>& path);

}  // namespace telepalp::probe
