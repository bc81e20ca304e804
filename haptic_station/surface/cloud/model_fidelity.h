#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "haptic_station/surface/cloud/winding_number.h"

namespace telepalp::surface {

/// Errors of the point-set surface against the mesh from which it was sampled, at random test points. Half of the
/// points are drawn by area and half by face, because small features have small faces.
struct Fidelity {
  double error_m = 0.0;  ///< 99 % quantile of the distance between surface and mesh
  double missing = 0.0;  ///< share of test points without a touchable surface
  double in_air = 0.0;   ///< share of points 3 to 15 mm outside the mesh at which contact is felt
  double jumps = 0.0;    ///< share of presses in which the proxy jumps; see MeshJudge::share_of_jumps()
};

/// Walls of a mesh that are thinner than two spacings of its samples, at random places of its reachable area.
struct ThinWalls {
  struct Place {
    Eigen::Vector3d at_m = Eigen::Vector3d::Zero();  ///< relative to the mean of the mesh
    double wall_m = 0.0;                             ///< thickness, rounded up to a quarter of the spacing
  };
  double share = 0.0;         ///< of the reachable area, 0 to 1
  std::vector<Place> places;  ///< the three thinnest that are at least 20 mm apart, or fewer
};

/// Measures the Fidelity of surfaces that were sampled from one mesh. Owns its test points and keeps no reference to
/// the mesh.
class MeshJudge {
 public:
  /// `mesh`: points in metres, relative to their mean. `side`: 1, or -1 to reverse all normals.
  MeshJudge(const models::PointModel& mesh, float side, std::uint64_t seed);

  /// False when the mesh has no area that can be reached from outside.
  [[nodiscard]] bool has_places() const noexcept { return !places_.empty(); }

  /// Removes each point whose outer side lies inside another part of the mesh. Returns the removed share, 0 to 1.
  double leave_out_hidden(std::vector<CloudPoint>& points) const;

  /// Measures `error_m`, `missing` and `in_air` of the surface; `jumps` stays 0.
  [[nodiscard]] Fidelity judge(const CloudSnapshot& snapshot) const;

  /// Presses 2 mm deep at about 300 test points with 10 mm of body below, and slides 5 mm sideways. Returns the
  /// share of presses in which the offset from hand to proxy changes by over 0.4 mm while the hand moves by 0.05 mm.
  [[nodiscard]] double share_of_jumps(const CloudSnapshot& snapshot) const;

  /// Looks for walls thinner than two spacings. `spacing_m`: that of the snapshot's points; if the snapshot is graded,
  /// a third of the nearest point's support is the spacing. An open sheet has no thickness and counts as no wall.
  [[nodiscard]] ThinWalls thin_walls(const CloudSnapshot& snapshot, double spacing_m) const;

 private:
  [[nodiscard]] bool encloses(const Eigen::Vector3d& at) const;
  [[nodiscard]] double share_in_air(const CloudSnapshot& snapshot) const;
  [[nodiscard]] double wall_m(const CloudPoint& place, double below_m) const;
  [[nodiscard]] bool can_be_pressed(const CloudPoint& place) const;

  float side_;
  WindingNumber winding_;
  std::shared_ptr<const NeighborIndex> near_;  // over the mesh's vertices and the centres of its faces
  std::vector<CloudPoint> places_;             // test points; their normals point outwards
  std::size_t by_area_ = 0;                    // so many of the first ones are drawn by area
};

}  // namespace telepalp::surface
