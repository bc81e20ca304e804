#include "haptic_station/surface/grid/grid_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptic_station/surface/grid/node_cover.h"
#include "haptic_station/surface/grid/node_sums.h"
#include "proto/words/smooth_step.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr double kNearestDepth_m = 1e-3;

/// A point's coordinates in the lattice of nodes, with their derivatives by the point.
struct LatticePoint {
  double column = 0.0;
  double row = 0.0;
  Vector3d column_by_m;
  Vector3d row_by_m;
};

LatticePoint to_lattice(const GridLayout& grid, const Vector3d& at) noexcept {
  const double per_z = 1.0 / (at.z() * grid.step_px);
  const double x = at.x() / at.z();
  const double y = at.y() / at.z();
  return {(grid.camera.fx * x + grid.camera.cx - grid.left_px) / grid.step_px,
          (grid.camera.fy * y + grid.camera.cy - grid.top_px) / grid.step_px,
          Vector3d(grid.camera.fx * per_z, 0.0, -grid.camera.fx * x * per_z),
          Vector3d(0.0, grid.camera.fy * per_z, -grid.camera.fy * y * per_z)};
}

struct Window {
  int first = 0;
  int last = -1;
};

Window window(double centre, double radius, int count) noexcept {
  const double first = std::clamp(std::ceil(centre - radius), 0.0, static_cast<double>(count));
  const double last = std::clamp(std::floor(centre + radius), -1.0, static_cast<double>(count - 1));
  return {static_cast<int>(first), static_cast<int>(last)};
}

Vector3d vector_of(const std::array<float, 3>& v) noexcept {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// The sum of the weights on a lattice without holes, approximated by the integral of the polynomial over the disc. The
/// true sum varies by a few per cent as the query moves between nodes.
double full_weight(double support_nodes) noexcept {
  constexpr double kMeanWeight = 8.0 / 27.0;  // ∫ C ds over [0, 1]
  return std::numbers::pi * support_nodes * support_nodes * kMeanWeight;
}

double coverage_of_share(double share) noexcept { return smooth_step(kLeastCover, kWholeCover, share); }

/// f and its gradient, from the sums by the quotient and product rules.
FieldSample sample_of(const NodeSums& sums, const LatticePoint& at, double full_weight) noexcept {
  FieldSample out;
  const WeightedSums& sum = sums.value;
  out.coverage = coverage_of_share(sum.weight / full_weight);
  const double length = sum.normal.norm();
  if (out.coverage <= 0.0 || length < 1e-3 * sum.weight) return {};
  const Vector3d n = sum.normal / length;
  const double total = sum.plane + n.dot(sum.offset);
  out.valid = true;
  out.normal = n;
  out.f_m = 0.5 * total / sum.weight;
  const Vector3d turn = (sum.offset - n.dot(sum.offset) * n) / length;  // d(n·offset)/d(sum of normals)
  const auto total_by = [&](const WeightedSums& by) noexcept {
    return by.plane + n.dot(by.offset) + turn.dot(by.normal);
  };
  Vector3d rise = sum.normal + sum.weight * n;
  if (const GateSums& gate = sums.gate; gate.any)
    rise += gate.plane + gate.offset.transpose() * n + gate.normal.transpose() * turn - 2.0 * out.f_m * gate.weight;
  rise += (total_by(sums.by_column) - 2.0 * out.f_m * sums.by_column.weight) * at.column_by_m;
  rise += (total_by(sums.by_row) - 2.0 * out.f_m * sums.by_row.weight) * at.row_by_m;
  out.gradient = 0.5 * rise / sum.weight;
  out.velocity_m_per_s = sums.velocity / sum.weight;
  out.deviation_m = sums.deviation / sum.weight;
  return out;
}

}  // namespace

FieldSample GridSurface::evaluate(const Vector3d& query, const Vector3d& /*facing: a camera sees one side*/,
                                  const MotionBasis& basis) const noexcept {
  if (!(query.z() > kNearestDepth_m) || nodes_.empty()) return {};
  const LatticePoint at = to_lattice(layout_, query);
  if (!std::isfinite(at.column) || !std::isfinite(at.row)) return {};
  const Window columns = window(at.column, layout_.support_nodes, layout_.columns);
  const Window rows = window(at.row, layout_.support_nodes, layout_.rows);
  NodeSums sums;
  sum_nodes(layout_, nodes_.data(), {columns.first, columns.last, rows.first, rows.last}, at.column, at.row,
            query - layout_.origin_m, motion.moves ? &basis : nullptr, sums);
  return sample_of(sums, at, full_weight(layout_.support_nodes));
}

std::optional<Seed> GridSurface::seed(const Vector3d& query) const noexcept {
  if (!(query.z() > kNearestDepth_m) || nodes_.empty()) return std::nullopt;
  const LatticePoint at = to_lattice(layout_, query);
  const double column = std::round(at.column);
  const double row = std::round(at.row);
  if (!(column >= 0.0 && column < layout_.columns && row >= 0.0 && row < layout_.rows)) return std::nullopt;
  const GridNode& node = nodes_[static_cast<std::size_t>(row) * static_cast<std::size_t>(layout_.columns) +
                                static_cast<std::size_t>(column)];
  if (node.confidence <= 0.0F) return std::nullopt;
  const Vector3d there = layout_.origin_m + vector_of(node.at_m);
  return Seed{there, vector_of(node.normal).dot(query - there) >= 0.0};
}

void GridSurface::prefetch(const Vector3d& query) const noexcept {
  if (!(query.z() > kNearestDepth_m) || nodes_.empty()) return;
  const LatticePoint at = to_lattice(layout_, query);
  if (!std::isfinite(at.column) || !std::isfinite(at.row)) return;
  const Window columns = window(at.column, layout_.support_nodes, layout_.columns);
  const Window rows = window(at.row, layout_.support_nodes, layout_.rows);
  for (int row = rows.first; row <= rows.last; ++row)
    for (int column = columns.first; column <= columns.last; ++column)
      __builtin_prefetch(&nodes_[static_cast<std::size_t>(row) * static_cast<std::size_t>(layout_.columns) +
                                 static_cast<std::size_t>(column)]);
}

double GridSurface::stride_m(const Vector3d& query) const noexcept {
  return 0.5 * layout_.support_nodes * layout_.step_px * std::max(query.z(), kNearestDepth_m) / layout_.camera.fx;
}

}  // namespace telepalp::surface
