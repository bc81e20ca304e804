#pragma once

#include <array>
#include <vector>

#include "haptic_station/tissue/fem/elastic_body.h"
#include "haptic_station/tissue/fem/prism_mesh.h"

namespace telepalp::tissue {

/// A point of a deformed side.
struct SidePoint {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d rest_m = Eigen::Vector3d::Zero();  ///< the same point of the body at rest
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of its triangle, outwards
  double behind_m = 0.0;  ///< how far the tool is behind the plane of this triangle; negative: before it
  double away_m = 0.0;    ///< distance from the tool
};
using SidePoints = std::array<SidePoint, kPrismSides>;

/// The sides of a deformed prism as flat triangles. All of them are looked at: some hundreds, which takes less than a
/// hundredth of a step of the body.
class PrismSurface {
 public:
  explicit PrismSurface(const ElasticBody& body);

  /// The point of each side that is nearest to `tool_m`.
  [[nodiscard]] SidePoints nearest(const Eigen::Vector3d& tool_m, const NodeField& at) const;
  /// The normal of a deformed side, smoothed over the radius `radius_m` around a point of the body at rest.
  [[nodiscard]] Eigen::Vector3d normal_around(PrismSide side, const Eigen::Vector3d& rest_m, double radius_m,
                                              const NodeField& at) const;

 private:
  using Triangle = std::array<std::uint32_t, 3>;
  [[nodiscard]] SidePoint nearest(const Triangle& triangle, const Eigen::Vector3d& tool_m, const NodeField& at) const;

  const ElasticBody& body_;
  std::array<std::vector<Triangle>, kPrismSides> sides_;
};

/// True if the tool is behind all sides and above the bottom. The body must be roughly convex.
[[nodiscard]] bool is_inside(const SidePoints& sides, const Eigen::Vector3d& tool_m) noexcept;

}  // namespace telepalp::tissue
