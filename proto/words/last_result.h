#pragma once

#include <cmath>
#include <limits>

namespace telepalp {

/// Remembers a function's last argument and result: for a slow function, such as exp(), whose argument is constant over
/// many ticks because it depends only on the time between ticks. Always pass the same function to one object.
class LastResult {
 public:
  /// `function(x)`, which is called only if `x` differs from the last argument.
  template <class Function>
  [[nodiscard]] double of(double x, const Function& function) noexcept {
    if (x != x_) {
      x_ = x;
      result_ = function(x);
    }
    return result_;
  }

 private:
  double x_ = std::numeric_limits<double>::quiet_NaN();  // unequal to every argument
  double result_ = 0.0;
};

/// exp(x), remembered by LastResult. For x = -dt / tau: the factor of an exponential decay over one tick of length dt.
class LastExp {
 public:
  [[nodiscard]] double of(double x) noexcept {
    return last_.of(x, [](double y) noexcept { return std::exp(y); });
  }

 private:
  LastResult last_;
};

}  // namespace telepalp
