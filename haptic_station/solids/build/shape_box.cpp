#include "haptic_station/solids/build/shape_box.h"

#include <algorithm>

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

Box around_origin(const Vector3d& half_m) noexcept { return {-half_m, half_m}; }

/// The bounding box of a body of revolution.
Box about_axis(int axis, double radius_m, double half_length_m) noexcept {
  Vector3d half = Vector3d::Constant(radius_m);
  half[axis] = half_length_m;
  return around_origin(half);
}

Box of_lattice(const DistanceLattice& lattice) noexcept {
  const Vector3d last(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1);
  return {lattice.origin_m, lattice.origin_m + lattice.spacing_m * last};
}

}  // namespace

Box shape_box(const TreeNode& shape) noexcept {
  const auto& n = shape.numbers;
  switch (shape.op) {
    case Op::Sphere:
      return around_origin(Vector3d::Constant(n[0]));
    case Op::Capsule: {
      const Vector3d from(n[0], n[1], n[2]);
      const Vector3d to(n[3], n[4], n[5]);
      return widened({from.cwiseMin(to), from.cwiseMax(to)}, n[6]);
    }
    case Op::Torus:
    case Op::Arc:
      return about_axis(shape.axis, n[0] + n[1], n[1]);
    case Op::Box:
    case Op::Ellipsoid:
      return around_origin({n[0], n[1], n[2]});
    case Op::Cylinder:
      return about_axis(shape.axis, n[0], n[1]);
    case Op::Mesh:
      return of_lattice(*shape.lattice);
    default:
      return {};
  }
}

Box placed_box(const Box& box, const TreeNode& node) noexcept {
  if (!box.bounded()) return {};
  const Vector3d middle = 0.5 * (box.low + box.high);
  const Vector3d half = node.scale * (node.turn.cwiseAbs() * (0.5 * (box.high - box.low)));
  const Vector3d center = node.scale * (node.turn * middle) + node.shift;
  return {center - half, center + half};
}

Box joined(const Box& a, const Box& b) noexcept { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

Box common(const Box& a, const Box& b) noexcept {
  const Box both{a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)};
  return (both.low.array() <= both.high.array()).all() ? both : a;
}

Box widened(const Box& box, double by_m) noexcept {
  return {box.low - Vector3d::Constant(by_m), box.high + Vector3d::Constant(by_m)};
}

Box clipped(const Box& box, const Vector3d& normal, double offset_m) noexcept {
  Box kept = box;
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] == 1.0) kept.high[axis] = std::max(kept.low[axis], std::min(kept.high[axis], offset_m));
    if (normal[axis] == -1.0) kept.low[axis] = std::min(kept.high[axis], std::max(kept.low[axis], -offset_m));
  }
  return kept;
}

}  // namespace telepalp::solids
