#include "haptic_station/tissue/net/stiffness_map.h"

#include "haptic_station/tissue/net/cubic_nodes.h"

namespace telepalp::tissue {
namespace {

/// The factor of one coordinate in the cubic Lagrange polynomial of a node, where this coordinate is `n` / 3.
double factor(double share, int n) noexcept {
  double product = 1.0;
  for (int k = 0; k < n; ++k) product *= (3.0 * share - k) / (n - k);
  return product;
}

}  // namespace

double StiffnessMap::at(std::uint32_t triangle, const Eigen::Vector3d& shares) const noexcept {
  double sum = 0.0;
  for (std::size_t n = 0; n < kCubicNodes.size(); ++n)
    sum += values_[triangle][n] * factor(shares[0], kCubicNodes[n][0]) * factor(shares[1], kCubicNodes[n][1]) *
           factor(shares[2], kCubicNodes[n][2]);
  return sum;
}

}  // namespace telepalp::tissue
