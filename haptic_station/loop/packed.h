#pragma once

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace telepalp::loop {

/// A vector as three floats, each rounded to nearest. Floats halve the size of the recorded tick.
inline std::array<float, 3> packed(const Eigen::Vector3d& v) noexcept {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// A rotation as x, y, z, w.
inline std::array<float, 4> packed(const Eigen::Quaterniond& q) noexcept {
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()), static_cast<float>(q.w())};
}

/// A vector as three floats, each rounded towards zero, so that a force at its limit is never recorded above the limit.
/// NaN stays NaN.
inline std::array<float, 3> packed_towards_zero(const Eigen::Vector3d& v) noexcept {
  std::array<float, 3> floats = packed(v);
  for (int axis = 0; axis < 3; ++axis) {
    float& value = floats[static_cast<std::size_t>(axis)];
    if (std::abs(static_cast<double>(value)) > std::abs(v[axis]))
      value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) - 1U);  // the next float towards zero
  }
  return floats;
}

}  // namespace telepalp::loop
