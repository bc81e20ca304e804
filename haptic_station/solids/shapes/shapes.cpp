#include "haptic_station/solids/shapes/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::solids {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kMostNewtonSteps = 40;

/// A signed distance in a half-plane that ends at an axis. Coordinates: distance from the axis, position along the
/// axis.
struct ProfileAt {
  double m;
  Vector2d gradient;  ///< away from the axis, along the axis
};

/// The outline of a torus. For a tube wider than its ring, the part of the circle beyond the axis is no surface; there
/// the cusp on the axis is the nearest point.
ProfileAt ring_profile(const Vector2d& at, double ring_m, double tube_m) noexcept {
  const Vector2d from(at.x() - ring_m, at.y());
  const double length = from.norm();
  const Vector2d out = length > 0.0 ? Vector2d(from / length) : Vector2d(1.0, 0.0);
  if (length >= tube_m || ring_m + tube_m * out.x() >= 0.0) return {length - tube_m, out};
  const double cusp_m = std::sqrt(tube_m * tube_m - ring_m * ring_m);
  const Vector2d to(-at.x(), (at.y() < 0.0 ? -cusp_m : cusp_m) - at.y());
  const double depth_m = to.norm();
  return {-depth_m, depth_m > 0.0 ? Vector2d(to / depth_m) : Vector2d(0.0, 1.0)};
}

ProfileAt rectangle_profile(const Vector2d& at, double radius_m, double half_m) noexcept {
  const double side = at.y() < 0.0 ? -1.0 : 1.0;
  const Vector2d over(at.x() - radius_m, side * at.y() - half_m);
  if (over.x() <= 0.0 && over.y() <= 0.0)
    return over.x() >= over.y() ? ProfileAt{over.x(), {1.0, 0.0}} : ProfileAt{over.y(), {0.0, side}};
  const Vector2d beyond = over.cwiseMax(0.0);
  const double length = beyond.norm();
  return {length, {beyond.x() / length, side * beyond.y() / length}};
}

/// The two coordinate axes perpendicular to the axis of a shape of revolution.
struct Across {
  int first;
  int second;
  explicit Across(int axis) noexcept : first((axis + 1) % 3), second((axis + 2) % 3) {}
};

/// The solid of revolution of an outline about the axis.
template <class Profile>
ShapeAt revolved(const Vector3d& p, int axis, const Profile& profile) noexcept {
  const Across across(axis);
  const double radial_m = std::hypot(p[across.first], p[across.second]);
  const ProfileAt at = profile(Vector2d(radial_m, p[axis]));
  Vector3d gradient;
  gradient[axis] = at.gradient.y();
  gradient[across.first] = at.gradient.x() * (radial_m > 0.0 ? p[across.first] / radial_m : 1.0);
  gradient[across.second] = at.gradient.x() * (radial_m > 0.0 ? p[across.second] / radial_m : 0.0);
  return {at.m, gradient};
}

Vector3d any_across(const Vector3d& direction) noexcept {
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(direction[i]) < std::abs(direction[least])) least = i;
  return direction.cross(Vector3d::Unit(least)).normalized();
}

}  // namespace

ShapeAt sphere_at(const Vector3d& p, double radius_m) noexcept {
  const double length = p.norm();
  return {length - radius_m, length > 0.0 ? Vector3d(p / length) : Vector3d(Vector3d::UnitY())};
}

ShapeAt plane_at(const Vector3d& p, const Vector3d& normal, double offset_m) noexcept {
  return {normal.dot(p) - offset_m, normal};
}

ShapeAt capsule_at(const Vector3d& p, const Vector3d& from, const Vector3d& to, double radius_m) noexcept {
  const Vector3d along = to - from;
  const double squared = along.squaredNorm();
  if (!(squared > 0.0)) return sphere_at(p - from, radius_m);
  const double share = std::clamp((p - from).dot(along) / squared, 0.0, 1.0);
  const Vector3d out = p - from - share * along;
  const double length = out.norm();
  return {length - radius_m, length > 0.0 ? Vector3d(out / length) : any_across(along / std::sqrt(squared))};
}

ShapeAt torus_at(const Vector3d& p, int axis, double ring_m, double tube_m) noexcept {
  return revolved(p, axis, [&](const Vector2d& at) noexcept { return ring_profile(at, ring_m, tube_m); });
}

ShapeAt arc_at(const Vector3d& p, int axis, double ring_m, double tube_m, ArcSpan span) noexcept {
  const Across across(axis);
  const double angle = std::atan2(p[across.second], p[across.first]);
  const double off = std::remainder(angle - span.middle_rad, 2.0 * std::numbers::pi);
  if (std::abs(off) <= span.half_sweep_rad) return torus_at(p, axis, ring_m, tube_m);
  const double end_rad = span.middle_rad + (off < 0.0 ? -span.half_sweep_rad : span.half_sweep_rad);
  Vector3d end = Vector3d::Zero();
  end[across.first] = ring_m * std::cos(end_rad);
  end[across.second] = ring_m * std::sin(end_rad);
  return sphere_at(p - end, tube_m);
}

ShapeAt box_at(const Vector3d& p, const Vector3d& half_m) noexcept {
  const Vector3d side(p.x() < 0.0 ? -1.0 : 1.0, p.y() < 0.0 ? -1.0 : 1.0, p.z() < 0.0 ? -1.0 : 1.0);
  const Vector3d over = p.cwiseAbs() - half_m;
  int nearest = 0;
  for (int i = 1; i < 3; ++i)
    if (over[i] > over[nearest]) nearest = i;
  if (over[nearest] <= 0.0) return {over[nearest], side[nearest] * Vector3d::Unit(nearest)};
  const Vector3d beyond = over.cwiseMax(0.0);
  const double length = beyond.norm();
  return {length, side.cwiseProduct(beyond) / length};
}

// The nearest point q solves q_i = r_i^2 y_i / (t + r_i^2) with sum (r_i y_i / (t + r_i^2))^2 = 1. Newton's method on
// 1 - 1/sqrt(sum) is monotone from the left, as for trust regions (More and Sorensen 1983), and needs few steps.
ShapeAt ellipsoid_at(const Vector3d& p, const Vector3d& radii_m) noexcept {
  const double scale = radii_m.maxCoeff();
  const Vector3d r = radii_m / scale;
  // At a coordinate of zero the nearest point may lie on either side, and Newton's method would lose it. A coordinate
  // of 1e-12 instead shifts the result by at most 1e-12.
  const Vector3d side(p.x() < 0.0 ? -1.0 : 1.0, p.y() < 0.0 ? -1.0 : 1.0, p.z() < 0.0 ? -1.0 : 1.0);
  const Vector3d y = (p.cwiseAbs() / scale).cwiseMax(1e-12);
  const Vector3d r2 = r.cwiseProduct(r);
  const Vector3d ry = r.cwiseProduct(y);
  // u = t + least2 is iterated instead of t, which would lose digits near the pole t = -least2.
  const double least2 = r2.minCoeff();
  const Vector3d above = r2 - Vector3d::Constant(least2);
  double u = (ry - above).maxCoeff();
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    const Vector3d base = above + Vector3d::Constant(u);
    const Vector3d w = ry.cwiseQuotient(base);
    const double sum = w.squaredNorm();
    const double slope = -2.0 * w.cwiseProduct(w).cwiseQuotient(base).sum();
    const double step = (std::sqrt(sum) - 1.0) * 2.0 * sum / slope;
    u -= step;
    if (!(std::abs(step) > 1e-15 * u)) break;
  }
  const Vector3d q = r2.cwiseProduct(y).cwiseQuotient(above + Vector3d::Constant(u));
  const Vector3d normal = side.cwiseProduct(q.cwiseQuotient(r2)).normalized();
  const double distance = (y - q).norm();
  return {scale * (u < least2 ? -distance : distance), normal};
}

ShapeAt cylinder_at(const Vector3d& p, int axis, double radius_m, double half_length_m) noexcept {
  return revolved(p, axis, [&](const Vector2d& at) noexcept { return rectangle_profile(at, radius_m, half_length_m); });
}

ShapeAt mesh_at(const Vector3d& p, const DistanceLattice& lattice) noexcept {
  // The spline needs one node beyond its cell on each side.
  const double inset_m = lattice.spacing_m * (1.0 + 1e-9);
  const Vector3d last(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1);
  const Vector3d low = lattice.origin_m + Vector3d::Constant(inset_m);
  const Vector3d high = lattice.origin_m + lattice.spacing_m * last - Vector3d::Constant(inset_m);
  const Vector3d near = p.cwiseMax(low).cwiseMin(high);
  const DistanceAt at = distance_at(lattice, near);
  const Vector3d gap = p - near;
  const double gap2 = gap.squaredNorm();
  if (!(gap2 > 0.0)) return {at.m, at.gradient};
  const double distance = std::sqrt(gap2 + at.m * at.m);
  Vector3d gradient = gap;
  for (int i = 0; i < 3; ++i)
    if (gap[i] == 0.0) gradient[i] = at.m * at.gradient[i];
  return {distance, gradient / distance};
}

}  // namespace telepalp::solids
