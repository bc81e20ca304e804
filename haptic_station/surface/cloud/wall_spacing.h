#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/cloud/cloud_surface.h"

namespace telepalp::surface {

/// The spacing of a mesh's samples at each place, chosen so that each wall is at least two spacings thick. At a thinner
/// wall, samples of both sides would lie within the support of one place of the surface. Between thin and thick walls
/// the spacing changes slowly enough for supports of kSupportGrade.
class WallSpacing {
 public:
  /// Measures the walls. `points`: samples of the mesh `most_m` apart, with normals out of the body. The spacing is
  /// `most_m` everywhere until choose().
  WallSpacing(const std::vector<CloudPoint>& points, double most_m);

  /// Chooses the spacings, between `least_m` and the widest one.
  void choose(double least_m);

  /// The spacing at a place of the mesh [m].
  [[nodiscard]] double at_m(const Eigen::Vector3f& place) const;
  /// Approximate number of samples with these spacings.
  [[nodiscard]] double samples() const;
  /// True when a wall is thinner than two of the widest spacings.
  [[nodiscard]] bool differs() const;

 private:
  [[nodiscard]] double wall_m(const CloudPoint& point) const;
  [[nodiscard]] bool grade();

  const std::vector<CloudPoint>& points_;  // owned by the caller
  double most_m_;
  std::shared_ptr<const NeighborIndex> index_;
  std::vector<double> wall_m_;         ///< at each of the points; infinite: thick enough
  std::vector<Neighbor> near_;         ///< the nearest neighbours of all points, one point's after the other's
  std::vector<std::size_t> near_end_;  ///< of each point in near_
  std::vector<double> spacing_m_;      ///< at each of the points
};

}  // namespace telepalp::surface
