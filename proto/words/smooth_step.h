#pragma once

#include <algorithm>

namespace telepalp {

/// The cubic smooth step: 0 for t <= 0, 1 for t >= 1, with zero slope at both ends.
[[nodiscard]] inline double smooth_step(double t) noexcept {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// The cubic smooth step from 0 at `from` to 1 at `to`. `to` may be less than `from`, but not equal.
[[nodiscard]] inline double smooth_step(double from, double to, double at) noexcept {
  return smooth_step((at - from) / (to - from));
}

}  // namespace telepalp
