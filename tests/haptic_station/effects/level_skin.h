#pragma once

#include <Eigen/Core>
#include <initializer_list>

#include "haptic_station/effects/effect_bank.h"

namespace telepalp::effects {

inline constexpr double kMost_N = 10.0;                  ///< largest force of the device
inline const Eigen::Vector3d kNeedle_m{0.0, -0.1, 0.0};  ///< from the device point to the tip of a needle

/// Input over the level skin y = 0.
inline EffectInput over_level_skin(const Eigen::Vector3d& device_m) {
  EffectInput in;
  in.device.m = device_m;
  in.contact.proxy.m = {device_m.x(), 0.0, device_m.z()};
  in.contact.normal.v = Eigen::Vector3d::UnitY();
  in.contact.distance_m = device_m.y();
  in.contact.in_body = device_m.y() < 0.0;
  in.contact.valid = true;
  return in;
}

/// `effects`, begun with the device at the origin.
inline EffectBank bank_of(std::initializer_list<EffectBank::Effect> effects) {
  EffectBank bank;
  for (const EffectBank::Effect& effect : effects) (void)bank.add(effect);
  bank.begin(over_level_skin({0.0, 0.0, 0.0}));
  return bank;
}

}  // namespace telepalp::effects
