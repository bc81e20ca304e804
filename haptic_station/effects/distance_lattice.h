#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace telepalp::effects {

/// How far it is to a closed surface, sampled on a lattice: positive outside, negative inside [m].
struct DistanceLattice {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< of the first node, in the surface's frame
  double spacing_m = 0.0;
  std::array<int, 3> size{};   ///< nodes along x, y, z; x runs fastest
  std::vector<float> nodes_m;  ///< size[0] * size[1] * size[2]

  [[nodiscard]] std::size_t index(int i, int j, int k) const noexcept {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
};

/// A distance with its derivative.
struct DistanceAt {
  double m = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< away from the surface's inside
};

/// The distance at a point as a cubic B-spline over the nodes: twice continuously differentiable, and the gradient is
/// its exact derivative, so that a spring on it can make no energy. The spline smooths: on a surface of curvature
/// radius R it lies spacing^2 / (3 R) outside of it, a fifth of a millimetre at 4 mm and R = 27 mm. Beyond the lattice,
/// and where the point is not finite: infinitely far. Real-time safe.
[[nodiscard]] DistanceAt distance_at(const DistanceLattice& lattice, const Eigen::Vector3d& point_m) noexcept;

}  // namespace telepalp::effects
