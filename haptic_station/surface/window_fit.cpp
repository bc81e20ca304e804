#include "haptic_station/surface/window_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <cstdlib>

namespace telepalp::surface {
namespace {

constexpr int kMostRadius = 16;
constexpr int kMostSide = 2 * kMostRadius + 1;

struct Pixel {
  int column = 0;
  int row = 0;
};

std::size_t index_of(const InverseDepthView& view, Pixel at) noexcept {
  return static_cast<std::size_t>(at.row) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(at.column);
}

bool inside(const InverseDepthView& view, Pixel at) noexcept {
  return at.column >= 0 && at.row >= 0 && at.column < view.width && at.row < view.height;
}

bool measured(const InverseDepthView& view, Pixel at) noexcept {
  return inside(view, at) && view.per_m[index_of(view, at)] > 0.0F;
}

std::optional<Pixel> nearest_measured(const InverseDepthView& view, Pixel centre, int most) noexcept {
  for (int ring = 0; ring <= most; ++ring)
    for (int dv = -ring; dv <= ring; ++dv)
      for (int du = -ring; du <= ring; ++du) {
        const Pixel at{centre.column + du, centre.row + dv};
        if (std::max(std::abs(du), std::abs(dv)) == ring && measured(view, at)) return at;
      }
  return std::nullopt;
}

/// The window's pixels reached from `start` over unbroken links, at most kMostSide², in `found`.
struct Connected {
  std::array<Pixel, static_cast<std::size_t>(kMostSide) * kMostSide> found;
  std::size_t count = 0;
};

void connect(const InverseDepthView& view, Pixel centre, Pixel start, int radius, Connected& connected) noexcept {
  std::array<bool, static_cast<std::size_t>(kMostSide) * kMostSide> seen{};
  const auto visit = [&](Pixel at, bool linked) {
    const int du = at.column - centre.column;
    const int dv = at.row - centre.row;
    if (!linked || std::abs(du) > radius || std::abs(dv) > radius || !measured(view, at)) return;
    bool& here = seen[static_cast<std::size_t>((dv + radius) * (2 * radius + 1) + du + radius)];
    if (here) return;
    here = true;
    connected.found[connected.count++] = at;
  };
  connected.count = 0;
  visit(start, true);
  for (std::size_t next = 0; next < connected.count; ++next) {
    const Pixel at = connected.found[next];
    const std::uint8_t broken = view.breaks[index_of(view, at)];
    visit({at.column + 1, at.row}, (broken & kBrokenRight) == 0);
    visit({at.column, at.row + 1}, (broken & kBrokenBelow) == 0);
    const Pixel left{at.column - 1, at.row};
    const Pixel above{at.column, at.row - 1};
    visit(left, inside(view, left) && (view.breaks[index_of(view, left)] & kBrokenRight) == 0);
    visit(above, inside(view, above) && (view.breaks[index_of(view, above)] & kBrokenBelow) == 0);
  }
}

/// Weighted least squares in N terms, taken from the 6-term normal equations' leading block.
template <int N>
std::optional<InverseDepthPlane> solve(const Eigen::Matrix<double, 6, 6>& normal,
                                       const Eigen::Matrix<double, 6, 1>& right) {
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> factors(normal.topLeftCorner<N, N>());
  const auto pivots = factors.vectorD();
  if (!(pivots.minCoeff() > 1e-9 * pivots.maxCoeff())) return std::nullopt;
  const Eigen::Matrix<double, N, 1> x = factors.solve(right.head<N>());
  return InverseDepthPlane{x[0], x[1], x[2]};
}

constexpr double kWholeEnoughForQuadratic = 0.8;
constexpr double kLeastShare = 0.25;
constexpr double kLeastShareOverHole = 0.5;

}  // namespace

std::optional<WindowFit> fit_window(const InverseDepthView& view, int column, int row, std::span<const double> weights,
                                    int bridge_px) {
  const int radius = static_cast<int>(weights.size()) - 1;
  const Pixel centre{column, row};
  const std::optional<Pixel> start = nearest_measured(view, centre, bridge_px);
  if (radius > kMostRadius || !start) return std::nullopt;
  Connected connected;
  connect(view, centre, *start, radius, connected);

  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  const double scale = 1.0 / radius;
  for (std::size_t i = 0; i < connected.count; ++i) {
    const Pixel at = connected.found[i];
    const int du = at.column - column;
    const int dv = at.row - row;
    const double w = weights[static_cast<std::size_t>(std::abs(du))] * weights[static_cast<std::size_t>(std::abs(dv))];
    const double u = du * scale;
    const double v = dv * scale;
    Eigen::Matrix<double, 6, 1> terms;
    terms << 1.0, u, v, u * u, u * v, v * v;
    normal.noalias() += w * terms * terms.transpose();
    right += w * static_cast<double>(view.per_m[index_of(view, at)]) * terms;
  }
  double whole = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) whole += 2.0 * weights[k];
  WindowFit fit{.plane = {}, .share = normal(0, 0) / (whole * whole)};
  const bool over_hole = start->column != column || start->row != row;
  if (fit.share < (over_hole ? kLeastShareOverHole : kLeastShare)) return std::nullopt;
  std::optional<InverseDepthPlane> plane;
  if (fit.share >= kWholeEnoughForQuadratic) plane = solve<6>(normal, right);
  if (!plane) plane = solve<3>(normal, right);
  if (!plane || !(plane->at > 0.0)) return std::nullopt;
  fit.plane = {plane->at, plane->across * scale, plane->down * scale};
  return fit;
}

}  // namespace telepalp::surface
