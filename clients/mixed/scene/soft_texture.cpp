#include "clients/mixed/scene/soft_texture.h"

#include <cmath>
#include <cstdint>

#include "proto/words/smooth_step.h"

namespace telepalp::mixed {
namespace {

/// A fixed number from 0 to 1 for each lattice point.
double lattice(std::int64_t x, std::int64_t y, std::int64_t z) {
  auto hash = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U ^
              static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FU ^ static_cast<std::uint64_t>(z) * 0x165667B19E3779F9U;
  hash ^= hash >> 29U;
  hash *= 0xBF58476D1CE4E5B9U;
  hash ^= hash >> 32U;
  return static_cast<double>(hash & 0xFFFFU) / 65535.0;
}

/// Value noise: lattice values, interpolated smoothly.
double soft_noise(const Eigen::Vector3d& at) {
  const Eigen::Vector3d floor = at.array().floor();
  const auto x = static_cast<std::int64_t>(floor.x()), y = static_cast<std::int64_t>(floor.y()),
             z = static_cast<std::int64_t>(floor.z());
  const double tx = smooth_step(at.x() - floor.x()), ty = smooth_step(at.y() - floor.y()),
               tz = smooth_step(at.z() - floor.z());
  const auto line = [&](int dy, int dz) {
    return std::lerp(lattice(x, y + dy, z + dz), lattice(x + 1, y + dy, z + dz), tx);
  };
  return std::lerp(std::lerp(line(0, 0), line(1, 0), ty), std::lerp(line(0, 1), line(1, 1), ty), tz);
}

bool is_ink(const Eigen::Vector3d& at) {
  constexpr double kLine_m = 0.006, kLetter_m = 0.003;
  const auto line = static_cast<std::int64_t>(std::floor((at.y() + at.z()) / kLine_m));
  const auto letter = static_cast<std::int64_t>(std::floor(at.x() / kLetter_m));
  const double height = (at.y() + at.z()) / kLine_m - static_cast<double>(line);
  return height < 0.5 && lattice(line, letter, 7) < 0.6;
}

}  // namespace

Eigen::Vector3d painted(const Paint& paint, const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d sun = Eigen::Vector3d(-0.4, -0.5, 0.77).normalized();
  const double shade = 0.7 + 0.3 * std::max(0.0, normal.dot(sun));
  const Eigen::Vector3d scaled = at / paint.scale_m;
  const double wide = soft_noise(scaled) - 0.5, narrow = soft_noise(2.7 * scaled + Eigen::Vector3d(3, 1, 2)) - 0.5;
  const Eigen::Vector3d tint(wide, 0.6 * wide + 0.3 * narrow, 0.5 * narrow);
  if (paint.printed && is_ink(at)) return shade * Eigen::Vector3d(40, 40, 44);
  return shade * (paint.color + paint.contrast * (70.0 * tint + Eigen::Vector3d::Constant(24.0 * narrow)));
}

}  // namespace telepalp::mixed
