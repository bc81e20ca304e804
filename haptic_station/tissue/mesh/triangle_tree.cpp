#include "haptic_station/tissue/mesh/triangle_tree.h"

#include <cmath>
#include <limits>

#include "haptic_station/tissue/mesh/nearest_shares.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

/// The share of the segment `way` at which it meets the triangle, and the barycentric coordinates there. Edges and
/// corners belong to the triangle, with a margin of 1e-9, so that no segment passes between two triangles.
std::optional<std::pair<double, Vector3d>> meet(const Vector3d& from, const Vector3d& way, const Vector3d& a,
                                                const Vector3d& b, const Vector3d& c) noexcept {
  constexpr double kMargin = 1e-9;
  const Vector3d ab = b - a;
  const Vector3d ac = c - a;
  const Vector3d normal = ab.cross(ac);
  const double slope = way.dot(normal);
  if (slope == 0.0) return std::nullopt;
  const double share = (a - from).dot(normal) / slope;
  if (!(share >= 0.0 && share <= 1.0)) return std::nullopt;
  const Vector3d r = from + share * way - a;
  const double v = r.cross(ac).dot(normal) / normal.squaredNorm();
  const double w = ab.cross(r).dot(normal) / normal.squaredNorm();
  if (v < -kMargin || w < -kMargin || v + w > 1.0 + kMargin) return std::nullopt;
  return std::pair(share, Vector3d(1.0 - v - w, v, w));
}

}  // namespace

MeshPoint TriangleTree::nearest(const Vector3d& to_m) const noexcept {
  MeshPoint best;
  double least_m2 = std::numeric_limits<double>::infinity();
  search(to_m, least_m2, [&](std::uint32_t triangle) {
    const Triangle& t = mesh_->triangles()[triangle];
    const auto corner = [&](int i) -> const Vector3d& { return mesh_->vertices()[t[i]]; };
    const Vector3d shares = nearest_shares(to_m, corner(0), corner(1), corner(2));
    const Vector3d at_m = shares[0] * corner(0) + shares[1] * corner(1) + shares[2] * corner(2);
    if (const double m2 = (at_m - to_m).squaredNorm(); m2 < least_m2) {
      least_m2 = m2;
      best = {triangle, shares, at_m};
    }
  });
  return best;
}

std::optional<MeshPoint> TriangleTree::first_hit(const Vector3d& from_m, const Vector3d& to_m) const noexcept {
  const Vector3d way_m = to_m - from_m;
  Eigen::AlignedBox3d swept(from_m.cwiseMin(to_m), from_m.cwiseMax(to_m));
  std::optional<MeshPoint> hit;
  double least = 2.0;
  std::uint32_t stack[64];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t at = stack[--depth];
    const Node& node = nodes_[at];
    if (!node.box.intersects(swept)) continue;
    if (node.count == 0) {
      stack[depth++] = at + 1;
      stack[depth++] = node.first;
      continue;
    }
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const Triangle& t = mesh_->triangles()[order_[node.first + i]];
      const auto met = meet(from_m, way_m, mesh_->vertices()[t[0]], mesh_->vertices()[t[1]], mesh_->vertices()[t[2]]);
      if (!met || met->first >= least) continue;
      least = met->first;
      hit = MeshPoint{order_[node.first + i], met->second, from_m + least * way_m};
    }
  }
  return hit;
}

}  // namespace telepalp::tissue
