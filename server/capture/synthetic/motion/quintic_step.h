#pragma once

#include <algorithm>

namespace telepalp::capture {

/// A value with its rate of change.
struct Changing {
  double value = 0.0;
  double rate = 0.0;
};

/// A smooth step by a polynomial of degree 5: 0 for t <= 0, 1 for t >= 1, twice continuously differentiable. `rate` is
/// the derivative by `t`.
[[nodiscard]] inline Changing quintic_step(double t) noexcept {
  const double x = std::clamp(t, 0.0, 1.0);
  return {.value = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x), .rate = 30.0 * x * x * (1.0 - x) * (1.0 - x)};
}

}  // namespace telepalp::capture
