#include "haptic_station/solids/distance_lattice.h"

#include <cmath>
#include <limits>

#include "proto/words/numbers/cubic_b_spline.h"

namespace telepalp::solids {
DistanceAt distance_at(const DistanceLattice& lattice, const Eigen::Vector3d& point_m) noexcept {
  const Eigen::Vector3d at = (point_m - lattice.origin_m) / lattice.spacing_m;
  std::array<int, 3> cell{};
  std::array<CubicBSpline<double>, 3> weights;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    // The negated comparison also treats NaN as beyond the lattice.
    if (!(at[axis] >= 1.0 && at[axis] < lattice.size[a] - 2))
      return {std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
    cell[a] = static_cast<int>(at[axis]);
    weights[a] = cubic_b_spline(at[axis] - cell[a]);
  }
  DistanceAt sum;
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 4; ++j) {
      const float* row = &lattice.nodes_m[lattice.index(cell[0] - 1, cell[1] - 1 + j, cell[2] - 1 + k)];
      double along = 0.0;
      double slope = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        along += weights[0].weight[i] * row[i];
        slope += weights[0].slope[i] * row[i];
      }
      const auto y = static_cast<std::size_t>(j);
      const auto z = static_cast<std::size_t>(k);
      sum.m += weights[1].weight[y] * weights[2].weight[z] * along;
      sum.gradient += Eigen::Vector3d{weights[1].weight[y] * weights[2].weight[z] * slope,
                                      weights[1].slope[y] * weights[2].weight[z] * along,
                                      weights[1].weight[y] * weights[2].slope[z] * along};
    }
  }
  sum.gradient /= lattice.spacing_m;
  return sum;
}

}  // namespace telepalp::solids
