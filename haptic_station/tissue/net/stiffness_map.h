#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "haptic_station/tissue/mesh/surface_mesh.h"

namespace telepalp::tissue {

struct NetSettings {
  double spread_m = 0.012;  ///< radius of the disc over which the tip's load is spread; see StiffnessMap
  int subdivisions = 1;     ///< how often the triangles around the contact are subdivided, 0 to 3
};

/// Least and greatest stiffness of a net at any place of contact, relative to its middle.
struct StiffnessRange {
  double least = 1.0;
  double most = 1.0;
};

/// The stiffness that a tense net of springs shows to a tip that pulls it, for each place of the contact.
///
/// Vertices are joined by springs of one stiffness along the edges; vertices on the rim are fixed. Around the contact
/// triangle, each triangle is subdivided into four (paper S4, docs/sources.md, section 3). In a lattice of equilateral
/// triangles, springs of stiffness k have the plane stiffness 2 k / sqrt(3) at any edge length, so the springs of the
/// children keep k. A new vertex on an edge between a subdivided and a whole triangle stays in the middle of that edge.
/// The load of the tip is spread over the radius `spread_m`, because a load on one vertex has no limit as the mesh gets
/// finer.
///
/// A subdivided net is softer under the same load: by 3 % in the middle of the nets of the scenes, and by 12 % near
/// their rims. A tip would feel this. S4 takes its rule for the children's springs from its source [7], which we could
/// not obtain. Our rule: at each place of contact, all springs of a net are scaled by one factor, so that the net shows
/// the force of its limit, the net of infinitely many subdivisions. The limit is extrapolated from the last subdivision
/// (Richardson: a halved edge leaves a quarter of the error), so the force hardly depends on their number. A net with
/// `subdivisions` 0 is not scaled. The force on the tip is the sum of the vertex forces (S4 eq. 2 and 6): the net's
/// stiffness × displacement.
///
/// The vertices' masses carry no force here: the net is at rest under its load at each tick. So the force depends on
/// the place of the contact and on the displacement alone, and is the gradient of one energy. The net is solved when a
/// scene is read; a tick interpolates between ten places of the contact triangle.
class StiffnessMap {
 public:
  static constexpr double kLeast = 0.1;  ///< least stiffness that a tip feels, relative to the middle
  static constexpr double kMost = 3.0;   ///< greatest one: near its fixed rim a net is much stiffer

  StiffnessMap(const SurfaceMesh& mesh, const NetSettings& settings);
  /// The stiffness relative to that at the middle of the mesh. `shares`: barycentric coordinates of the contact.
  [[nodiscard]] double at(std::uint32_t triangle, const Eigen::Vector3d& shares) const noexcept;
  /// The same within kLeast and kMost.
  [[nodiscard]] double felt_at(std::uint32_t triangle, const Eigen::Vector3d& shares) const noexcept {
    return std::clamp(at(triangle, shares), kLeast, kMost);
  }
  /// The least and the greatest relative stiffness at the places that are solved, within kLeast and kMost.
  [[nodiscard]] StiffnessRange range() const noexcept { return range_; }
  /// The stiffness of each spring of a net that shows 1 N/m at its middle [N/m].
  [[nodiscard]] double spring() const noexcept { return spring_; }

 private:
  std::vector<std::array<float, 10>> values_;  ///< relative stiffness of each triangle at kCubicNodes
  StiffnessRange range_;
  double spring_ = 1.0;
};

/// The displacement of the tip by 1 N, on springs of 1 N/m [m]: solved directly.
[[nodiscard]] double net_compliance(const SurfaceMesh& mesh, const NetSettings& settings, std::uint32_t triangle,
                                    const Eigen::Vector3d& shares);

}  // namespace telepalp::tissue
