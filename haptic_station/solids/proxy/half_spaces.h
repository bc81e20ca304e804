#pragma once

#include <Eigen/Core>
#include <span>

namespace telepalp::solids {

/// The side of a plane to which the unit vector `normal` points: normal . x >= offset.
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset_m;
};

/// The point nearest to `p` in the intersection of half-spaces, of which at most three hold the point. When `p` moves,
/// this point moves by no more than `p` does. For a few planes (eight at most), trying each set of one, two or three
/// planes costs less than a solver, and cannot cycle. Returns `otherwise` if the half-spaces have no common point, or
/// if the planes that hold it are parallel within 1e-5 rad. The search stops at a point that meets the
/// Karush-Kuhn-Tucker conditions; in a convex set only the nearest point does.
[[nodiscard]] Eigen::Vector3d nearest_in(std::span<const HalfSpace> spaces, const Eigen::Vector3d& p,
                                         const Eigen::Vector3d& otherwise) noexcept;

}  // namespace telepalp::solids
