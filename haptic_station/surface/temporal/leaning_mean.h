#pragma once

#include <algorithm>
#include <cmath>

namespace telepalp::surface {

/// Weight of the newest innovation in a running mean of innovations.
inline constexpr double kLeanGain = 0.3;

/// How significant a running mean of innovations is: 0 if it is at most `calm_up_to` times what noise alone gives, 1
/// from `quick_from` times on, linear between. `lean_m`: the mean [m]. `sigma_m`: standard deviation of an innovation
/// [m].
[[nodiscard]] inline double leaning(double lean_m, double sigma_m, double calm_up_to, double quick_from) noexcept {
  const double chance_m = sigma_m * std::sqrt(kLeanGain / (2.0 - kLeanGain)) + 1e-6;
  return std::clamp((std::abs(lean_m) / chance_m - calm_up_to) / (quick_from - calm_up_to), 0.0, 1.0);
}

}  // namespace telepalp::surface
