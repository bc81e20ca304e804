#pragma once

#include "haptic_station/ports/surface_contact.h"
#include "proto/words/frames.h"

namespace telepalp::effects {

/// What an effect may know at a tick.
struct EffectInput {
  Point<HapticBase> device;
  Vector<HapticBase> device_velocity;  ///< [m/s]
  ports::SurfaceContact contact;       ///< of `device`; valid, unless said otherwise
  Vector<HapticBase> moved;            ///< of the device since the last tick [m]
};

/// Where the device point is with respect to an inner object. Ordered by nearness.
enum class ObjectTouch { None, Near, Lateral, Upper };

// An effect is a value with these members, all noexcept and free of allocation:
//   void begin(const EffectInput&)                  the end-effector has just entered the body
//   Force<HapticBase> step(const EffectInput&, dt)  the force on the hand
//   double energy_J() const                         elastic energy stored at the last step
//   Vector<HapticBase> carried_at(const EffectInput&) const   velocity of what it is fixed to: the skin breathes
//   double stiffest_N_per_m(double most_N) const    of its spring, at forces up to `most_N`
//   ObjectTouch touch() const                       None, but for inner objects
//   static constexpr const char* kName
// EffectBank holds and steps them.

}  // namespace telepalp::effects
