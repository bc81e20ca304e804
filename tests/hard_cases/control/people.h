#pragma once

#include <algorithm>
#include <functional>
#include <numbers>

#include "haptic_station/device/trial.h"

namespace telepalp::hard_cases {

/// The hand's intended position at each tick.
using Person = std::function<device::Intention(const device::TrialView&)>;

inline Person waits_at(double height_m) {
  return [=](const device::TrialView&) { return device::Intention{{{0.0, height_m, 0.0}}, {}}; };
}

/// Goes down from 60 mm through the plane, from 0.7 to 1.5 s, and presses to `depth_m` under the skin at 0.
inline Person presses_to(double depth_m, double x_m = 0.0) {
  return [=](const device::TrialView& view) {
    const double share = std::clamp((view.time_s - 0.7) / 0.8, 0.0, 1.0);
    const double ease = share * share * (3.0 - 2.0 * share);
    return device::Intention{{{x_m, 0.06 - ease * (0.06 + depth_m), 0.0}}, {}};
  };
}

/// The same, and rubs sideways by `reach_m` about `x_m` once a second.
inline Person rubs_at(double depth_m, double reach_m, double x_m = 0.0) {
  return [=](const device::TrialView& view) {
    device::Intention aim = presses_to(depth_m, x_m)(view);
    aim.at.m.x() += reach_m * std::sin(2.0 * std::numbers::pi * view.time_s);
    return aim;
  };
}

/// Falls through the plane from 60 mm at `speed_m_per_s`, from 1.5 s on, and stays 30 mm deep.
inline Person falls_at(double speed_m_per_s, double x_m = 0.0) {
  return [=](const device::TrialView& view) {
    const double fallen_m = std::max(0.0, view.time_s - 1.5) * speed_m_per_s;
    return device::Intention{{{x_m, std::max(-0.03, 0.06 - fallen_m), 0.0}}, {}};
  };
}

}  // namespace telepalp::hard_cases
