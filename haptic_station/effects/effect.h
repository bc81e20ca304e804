#pragma once

#include <array>
#include <cstddef>

#include "haptic_station/ports/surface_contact.h"
#include "proto/words/frames.h"

namespace telepalp::effects {

/// Inputs of an effect at one tick of the haptic loop.
struct EffectInput {
  Point<HapticBase> device;
  Vector<HapticBase> device_velocity;  ///< [m/s]
  ports::SurfaceContact contact;       ///< surface at the point `device`
  Vector<HapticBase> moved;            ///< motion of the device since the last tick [m]
};

/// Where an object inside the body is displayed, against the place that the scene gives it.
struct Placement {
  Vector<HapticBase> moved;     ///< [m]
  Vector<HapticBase> velocity;  ///< [m/s]
};
inline constexpr std::size_t kMostEffects = 8;
/// By the effect's number in the bank.
using Placements = std::array<Placement, kMostEffects>;

/// How close the device point is to an object inside the body, in ascending order: not near, within its margin, pressed
/// from the side, pressed from above.
enum class ObjectTouch { None, Near, Lateral, Upper };

// An effect is a value with these members, all noexcept and free of allocation:
//   void begin(const EffectInput&)                  the end-effector has just entered the body
//   Force<HapticBase> step(const EffectInput&, dt)  the force on the hand
//   double energy_J() const                         elastic energy stored at the last step
//   Vector<HapticBase> carried_at(const EffectInput&) const   velocity of the body to which the effect is fixed, for
//   example the breathing skin double stiffest_N_per_m(double most_N) const    greatest stiffness of its spring at
//   forces up to `most_N` ObjectTouch touch() const                       None, except for objects inside the body
//   static constexpr const char* kName
//   Point<HapticBase> place() const                 of objects inside the body alone: where the scene puts it; the bank
//   lets such an effect feel the device as seen from the displaced object
// EffectBank holds and steps the effects of a scene.

}  // namespace telepalp::effects
