#include "haptic_station/surface/grid/grid_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptic_station/surface/snapshot/soft_object_weight.h"
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

double dot(const MotionTerms& a, const MotionTerms& b) noexcept {
  float sum = 0.0F;
  for (std::size_t term = 0; term < a.size(); ++term) sum += a[term] * b[term];
  return static_cast<double>(sum);
}

/// Weighted sums over the neighbours, and the derivatives of these sums by the two lattice coordinates.
struct Sums {
  double weight = 0.0, weight_u = 0.0, weight_v = 0.0;
  double plane = 0.0, plane_u = 0.0, plane_v = 0.0;
  Vector3d normal = Vector3d::Zero(), normal_u = Vector3d::Zero(), normal_v = Vector3d::Zero();
  Vector3d offset = Vector3d::Zero(), offset_u = Vector3d::Zero(), offset_v = Vector3d::Zero();
  double velocity = 0.0;
  double deviation = 0.0;
  // derivatives by the gate, along each node's normal; zero where no other surface is near
  bool gated = false;
  Vector3d weight_g = Vector3d::Zero();
  Vector3d plane_g = Vector3d::Zero();
  Eigen::Matrix3d normal_g = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d offset_g = Eigen::Matrix3d::Zero();
};

void add_gate(Sums& sums, double by_distance, double plane, const Vector3d& normal, const Vector3d& offset) noexcept {
  sums.gated = true;
  const Vector3d by_m = by_distance * normal;
  sums.weight_g += by_m;
  sums.plane_g += plane * by_m;
  sums.normal_g += normal * by_m.transpose();
  sums.offset_g += offset * by_m.transpose();
}

void add(Sums& sums, const GridNode& node, const Vector3d& local, double du, double dv, const Weight& fade,
         double per_r2, double per_gate2, const MotionBasis& basis, bool moves) noexcept {
  const Vector3d normal = vector_of(node.normal);
  const double rise = moves ? dot(node.motion, basis.value) : 0.0;
  const Vector3d offset = local - vector_of(node.at_m) - rise * normal;
  const double plane = normal.dot(offset);
  const Weight gate = flat_top_weight(plane * plane * per_gate2);
  if (gate.value <= 0.0) return;
  const double present = static_cast<double>(node.confidence) * gate.value;
  const double w = present * fade.value;
  const double slope = -2.0 * per_r2 * present * fade.slope;  // the offset is node minus point
  const double wu = slope * du;
  const double wv = slope * dv;
  sums.weight += w;
  sums.weight_u += wu;
  sums.weight_v += wv;
  sums.plane += w * plane;
  sums.plane_u += wu * plane;
  sums.plane_v += wv * plane;
  sums.normal += w * normal;
  sums.normal_u += wu * normal;
  sums.normal_v += wv * normal;
  sums.offset += w * offset;
  sums.offset_u += wu * offset;
  sums.offset_v += wv * offset;
  sums.deviation += w * static_cast<double>(node.deviation_m);
  if (moves) sums.velocity += w * dot(node.motion, basis.rate);
  if (gate.slope != 0.0)
    add_gate(sums, static_cast<double>(node.confidence) * fade.value * gate.slope * 2.0 * plane * per_gate2, plane,
             normal, offset);
}

/// The sum of the weights on a lattice without holes, approximated by the integral of the polynomial over the disc. The
/// true sum varies by a few per cent as the query moves between nodes.
double full_weight(double support_nodes) noexcept {
  constexpr double kMeanWeight = 8.0 / 27.0;  // ∫ C ds over [0, 1]
  return std::numbers::pi * support_nodes * support_nodes * kMeanWeight;
}

/// Below the first coverage there is no surface; from the second on the support is full.
constexpr double kLeastCover = 0.30;
constexpr double kWholeCover = 0.55;

double support_of(double cover) noexcept { return smooth_step(kLeastCover, kWholeCover, cover); }

/// f and its gradient, from the sums by the quotient and product rules.
FieldSample sample_of(const Sums& sums, const LatticePoint& at, double full_weight) noexcept {
  FieldSample out;
  out.support = support_of(sums.weight / full_weight);
  const double length = sums.normal.norm();
  if (out.support <= 0.0 || length < 1e-3 * sums.weight) return {};
  const Vector3d n = sums.normal / length;
  const double total = sums.plane + n.dot(sums.offset);
  out.valid = true;
  out.normal = n;
  out.f_m = 0.5 * total / sums.weight;
  const Vector3d turn = (sums.offset - n.dot(sums.offset) * n) / length;  // d(n·offset)/d(sum of normals)
  const double total_u = sums.plane_u + n.dot(sums.offset_u) + turn.dot(sums.normal_u);
  const double total_v = sums.plane_v + n.dot(sums.offset_v) + turn.dot(sums.normal_v);
  Vector3d rise = sums.normal + sums.weight * n;
  if (sums.gated)
    rise +=
        sums.plane_g + sums.offset_g.transpose() * n + sums.normal_g.transpose() * turn - 2.0 * out.f_m * sums.weight_g;
  rise += (total_u - 2.0 * out.f_m * sums.weight_u) * at.column_by_m;
  rise += (total_v - 2.0 * out.f_m * sums.weight_v) * at.row_by_m;
  out.gradient = 0.5 * rise / sums.weight;
  out.velocity_m_per_s = sums.velocity / sums.weight;
  out.deviation_m = sums.deviation / sums.weight;
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
  const Vector3d local = query - layout_.origin_m;
  const double per_r2 = 1.0 / (layout_.support_nodes * layout_.support_nodes);
  const double per_gate2 = 1.0 / (layout_.gate_m * layout_.gate_m);
  Sums sums;
  for (int row = rows.first; row <= rows.last; ++row) {
    const double dv = row - at.row;
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(layout_.columns);
    for (int column = columns.first; column <= columns.last; ++column) {
      const double du = column - at.column;
      const Weight fade = soft_object_weight((du * du + dv * dv) * per_r2);
      if (fade.value <= 0.0) continue;
      const GridNode& node = nodes_[start + static_cast<std::size_t>(column)];
      if (node.confidence > 0.0F) add(sums, node, local, du, dv, fade, per_r2, per_gate2, basis, motion.moves);
    }
  }
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
