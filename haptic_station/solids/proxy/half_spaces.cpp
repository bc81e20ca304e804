#include "haptic_station/solids/proxy/half_spaces.h"

#include <Eigen/Geometry>
#include <cmath>

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;
using Spaces = std::span<const HalfSpace>;

constexpr double kAllowed_m = 1e-9;
constexpr double kParallel = 1e-10;  // planes are parallel if the determinant of their unit normals is below this

double height(const HalfSpace& space, const Vector3d& p) noexcept { return space.normal.dot(p) - space.offset_m; }

bool allowed(Spaces spaces, const Vector3d& p) noexcept {
  for (const HalfSpace& space : spaces)
    if (height(space, p) < -kAllowed_m) return false;
  return true;
}

// Each of the following moves `p` to the nearest point on the planes and returns true if each plane then pushes `p`
// outwards: a plane that would have to pull does not hold it.

bool on_plane(const HalfSpace& a, Vector3d& p) noexcept {
  const double depth_m = -height(a, p);
  p += depth_m * a.normal;
  return depth_m >= 0.0;
}

bool on_line(const HalfSpace& a, const HalfSpace& b, Vector3d& p) noexcept {
  const double c = a.normal.dot(b.normal);
  const double determinant = 1.0 - c * c;
  if (determinant < kParallel) return false;
  const double by_a = (c * height(b, p) - height(a, p)) / determinant;
  const double by_b = (c * height(a, p) - height(b, p)) / determinant;
  p += by_a * a.normal + by_b * b.normal;
  return by_a >= 0.0 && by_b >= 0.0;
}

bool on_corner(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c, Vector3d& p) noexcept {
  const Vector3d bc = b.normal.cross(c.normal);
  const Vector3d ca = c.normal.cross(a.normal);
  const Vector3d ab = a.normal.cross(b.normal);
  const double determinant = a.normal.dot(bc);
  if (determinant * determinant < kParallel) return false;
  const Vector3d corner = (a.offset_m * bc + b.offset_m * ca + c.offset_m * ab) / determinant;
  const Vector3d way = corner - p;
  p = corner;
  return bc.dot(way) / determinant >= 0.0 && ca.dot(way) / determinant >= 0.0 && ab.dot(way) / determinant >= 0.0;
}

bool on_one(Spaces s, const Vector3d& from, Vector3d& p) noexcept {
  for (const HalfSpace& a : s)
    if (p = from; on_plane(a, p) && allowed(s, p)) return true;
  return false;
}

bool on_two(Spaces s, const Vector3d& from, Vector3d& p) noexcept {
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = i + 1; j < s.size(); ++j)
      if (p = from; on_line(s[i], s[j], p) && allowed(s, p)) return true;
  return false;
}

bool on_three(Spaces s, const Vector3d& from, Vector3d& p) noexcept {
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = i + 1; j < s.size(); ++j)
      for (std::size_t k = j + 1; k < s.size(); ++k)
        if (p = from; on_corner(s[i], s[j], s[k], p) && allowed(s, p)) return true;
  return false;
}

}  // namespace

Vector3d nearest_in(Spaces spaces, const Vector3d& p, const Vector3d& otherwise) noexcept {
  Vector3d at = p;
  const bool found = allowed(spaces, p) || on_one(spaces, p, at) || on_two(spaces, p, at) || on_three(spaces, p, at);
  return found ? at : otherwise;
}

}  // namespace telepalp::solids
