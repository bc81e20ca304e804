#pragma once

#include <algorithm>
#include <cmath>

#include "haptic_station/mechanism/four_bar.h"

namespace telepalp::mechanism {

/// How fast the parameters of a linkage may change while it is in use.
struct SlewLimits {
  double lengths_m_per_s = 0.02;
  double angles_rad_per_s = 0.2;
};

/// Moves all parameters of `bar` towards `wanted` by the same share of their remaining change. So each linkage on the
/// way lies between two linkages that close, and closes too, because the condition for closing is linear in the
/// lengths.
inline void approach(FourBar& bar, const FourBar& wanted, const SlewLimits& limits, double dt_s) noexcept {
  constexpr double FourBar::*kLengths[] = {&FourBar::l1_m,     &FourBar::l2_m,        &FourBar::l3_m,    &FourBar::l4_m,
                                           &FourBar::needle_m, &FourBar::handle_at_m, &FourBar::handle_m};
  constexpr double FourBar::*kAngles[] = {&FourBar::needle_rad, &FourBar::handle_rad};
  double steps = 0.0;  // of `dt_s`, until the slowest parameter has arrived
  for (const auto length : kLengths)
    steps = std::max(steps, std::abs(wanted.*length - bar.*length) / (limits.lengths_m_per_s * dt_s));
  for (const auto angle : kAngles)
    steps = std::max(steps, std::abs(wanted.*angle - bar.*angle) / (limits.angles_rad_per_s * dt_s));
  if (!(steps > 1.0)) {
    bar = wanted;
    return;
  }
  for (const auto length : kLengths) bar.*length += (wanted.*length - bar.*length) / steps;
  for (const auto angle : kAngles) bar.*angle += (wanted.*angle - bar.*angle) / steps;
}

}  // namespace telepalp::mechanism
