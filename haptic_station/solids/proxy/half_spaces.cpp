#include "haptic_station/solids/proxy/half_spaces.h"

#include <Eigen/Geometry>
#include <cmath>

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

constexpr double kAllowed_m = 1e-9;
constexpr double kParallel = 1e-6;  // planes are parallel if the determinant of their unit normals is below this

double height(const HalfSpace& space, const Vector3d& p) noexcept { return space.normal.dot(p) - space.offset_m; }

bool allowed(std::span<const HalfSpace> spaces, const Vector3d& p) noexcept {
  for (const HalfSpace& space : spaces)
    if (height(space, p) < -kAllowed_m) return false;
  return true;
}

Vector3d on_plane(const HalfSpace& a, const Vector3d& p) noexcept { return p - height(a, p) * a.normal; }

/// The nearest point on the line of two planes; false for parallel planes.
bool on_line(const HalfSpace& a, const HalfSpace& b, const Vector3d& p, Vector3d& out) noexcept {
  const double c = a.normal.dot(b.normal);
  const double determinant = 1.0 - c * c;
  if (determinant < kParallel) return false;
  const double ha = height(a, p);
  const double hb = height(b, p);
  out = p + (c * hb - ha) / determinant * a.normal + (c * ha - hb) / determinant * b.normal;
  return true;
}

bool on_corner(std::span<const HalfSpace> s, Vector3d& out) noexcept {
  const Vector3d bc = s[1].normal.cross(s[2].normal);
  const double determinant = s[0].normal.dot(bc);
  if (std::abs(determinant) < kParallel) return false;
  out = (s[0].offset_m * bc + s[1].offset_m * s[2].normal.cross(s[0].normal) +
         s[2].offset_m * s[0].normal.cross(s[1].normal)) /
        determinant;
  return true;
}

/// Keeps the allowed candidate that is nearest to the point.
class Nearest {
 public:
  Nearest(std::span<const HalfSpace> spaces, const Vector3d& p) noexcept : spaces_(spaces), p_(p) {}
  void offer(const Vector3d& candidate) noexcept {
    const double squared = (candidate - p_).squaredNorm();
    if (squared >= best_squared_ || !allowed(spaces_, candidate)) return;
    best_ = candidate;
    best_squared_ = squared;
  }
  [[nodiscard]] bool found() const noexcept { return best_squared_ < HUGE_VAL; }
  [[nodiscard]] const Vector3d& best() const noexcept { return best_; }

 private:
  std::span<const HalfSpace> spaces_;
  const Vector3d& p_;
  Vector3d best_ = Vector3d::Zero();
  double best_squared_ = HUGE_VAL;
};

}  // namespace

// With at most three planes, trying each set of active planes is cheaper than a solver and cannot cycle.
Vector3d nearest_in(std::span<const HalfSpace> spaces, const Vector3d& p, const Vector3d& otherwise) noexcept {
  if (allowed(spaces, p)) return p;
  Nearest nearest(spaces, p);
  for (const HalfSpace& space : spaces) nearest.offer(on_plane(space, p));
  if (nearest.found()) return nearest.best();
  Vector3d candidate;
  for (std::size_t i = 0; i < spaces.size(); ++i)
    for (std::size_t j = i + 1; j < spaces.size(); ++j)
      if (on_line(spaces[i], spaces[j], p, candidate)) nearest.offer(candidate);
  if (nearest.found()) return nearest.best();
  if (spaces.size() == 3 && on_corner(spaces, candidate)) nearest.offer(candidate);
  return nearest.found() ? nearest.best() : otherwise;
}

}  // namespace telepalp::solids
