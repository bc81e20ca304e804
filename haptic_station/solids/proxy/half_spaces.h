#pragma once

#include <Eigen/Core>
#include <span>

namespace telepalp::solids {

/// The side of a plane to which the unit vector `normal` points: normal . x >= offset.
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset_m;
};

/// The point nearest to `p` in the intersection of at most three half-spaces. Of nearly parallel planes that face the
/// same way, the one with the larger offset decides; the line in which they intersect is far away and is not tried.
/// Returns `otherwise` if no common point of the half-spaces is found.
[[nodiscard]] Eigen::Vector3d nearest_in(std::span<const HalfSpace> spaces, const Eigen::Vector3d& p,
                                         const Eigen::Vector3d& otherwise) noexcept;

}  // namespace telepalp::solids
