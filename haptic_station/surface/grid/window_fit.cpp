#include "haptic_station/surface/grid/window_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace telepalp::surface {
namespace {

/// The part of the window that lies in the image.
struct Clip {
  int from = 0;
  int to = 0;
};

Clip clip_of(const InverseDepthView& view, int left, int side) noexcept {
  return {std::max(0, -left), std::min(side, view.width - left)};
}

/// The normal equations of 1, u, v, u², uv, v², lengths in radii.
struct PlaneEquations {
  Eigen::Matrix<double, 6, 6> normal;
  Eigen::Matrix<double, 6, 1> right;
};

PlaneEquations equations_of(const MaskedColumns& sums, const AxisWeights& axis, Clip clip) {
  std::array<std::array<double, 5>, 5> moment{};  // [power of u][power of v]
  std::array<std::array<double, 3>, 3> value{};
  const double scale = 1.0 / axis.radius;
  for (int k = clip.from; k < clip.to; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const int distance = k - axis.radius;
    double u = static_cast<double>(axis.by_distance[static_cast<std::size_t>(std::abs(distance))]);
    for (std::size_t a = 0; a < 5; ++a, u *= distance * scale) {
      for (std::size_t b = 0; a + b < 5; ++b) moment[a][b] += u * static_cast<double>(sums.weight[b][at]);
      for (std::size_t b = 0; a + b < 3; ++b) value[a][b] += u * static_cast<double>(sums.value[b][at]);
    }
  }
  constexpr std::array<std::array<std::size_t, 2>, 6> kPowers = {{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  const std::array<double, 5> by_power = {1.0, scale, scale * scale, scale * scale * scale,
                                          scale * scale * scale * scale};
  PlaneEquations out;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [a, b] = kPowers[i];
    out.right[static_cast<Eigen::Index>(i)] = value[a][b] * by_power[b];
    for (std::size_t j = 0; j < 6; ++j) {
      const auto [c, d] = kPowers[j];
      out.normal(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = moment[a + c][b + d] * by_power[b + d];
    }
  }
  return out;
}

/// Weighted least squares with the first N terms: solves the leading N × N block of the normal equations.
template <int N>
std::optional<InverseDepthPlane> solve(const PlaneEquations& equations) {
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> factors(equations.normal.topLeftCorner<N, N>());
  const auto pivots = factors.vectorD();
  if (!(pivots.minCoeff() > 1e-9 * pivots.maxCoeff())) return std::nullopt;
  const Eigen::Matrix<double, N, 1> x = factors.solve(equations.right.head<N>());
  return InverseDepthPlane{x[0], x[1], x[2]};
}

constexpr double kWholeEnoughForQuadratic = 0.8;
constexpr double kLeastShare = 0.25;
constexpr double kLeastShareOverHole = 0.5;

}  // namespace

std::optional<WindowFit> fit_window(const InverseDepthView& view, int column, int row, const AxisWeights& axis,
                                    int bridge_px) {
  const std::optional<WindowMask> mask = connected_pixels(view, column, row, axis.radius, bridge_px);
  if (!mask) return std::nullopt;
  const Pixel corner{column - axis.radius, row - axis.radius};
  const Clip clip = clip_of(view, corner.column, 2 * axis.radius + 1);
  MaskedColumns sums;
  const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(corner.row) * view.width + corner.column;
  sum_masked_columns(view.per_m.data(), first, view.width, mask->rows.data(), axis, clip.from, clip.to, sums);
  const PlaneEquations equations = equations_of(sums, axis, clip);
  WindowFit fit{.plane = {}, .share = equations.normal(0, 0) / (axis.m0 * axis.m0)};
  const bool over_hole = mask->start.column != column || mask->start.row != row;
  if (fit.share < (over_hole ? kLeastShareOverHole : kLeastShare)) return std::nullopt;
  std::optional<InverseDepthPlane> plane;
  if (fit.share >= kWholeEnoughForQuadratic) plane = solve<6>(equations);
  if (!plane) plane = solve<3>(equations);
  if (!plane || !(plane->at + static_cast<double>(view.reference_per_m) > 0.0)) return std::nullopt;
  const double scale = 1.0 / axis.radius;
  fit.plane = {plane->at, plane->across * scale, plane->down * scale};
  return fit;
}

}  // namespace telepalp::surface
