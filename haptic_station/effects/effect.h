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

/// Displacement of an object inside the body from the place that the scene gives it, because the body moves.
struct Placement {
  Vector<HapticBase> moved;     ///< [m]
  Vector<HapticBase> velocity;  ///< [m/s]
};
inline constexpr std::size_t kMostEffects = 8;
/// One per effect, in the order in which EffectBank holds the effects.
using Placements = std::array<Placement, kMostEffects>;

/// How close the device point is to an object inside the body, in ascending order: not near, within the `around_m` of
/// the object's settings, pressed from the side, pressed from above.
enum class ObjectTouch { None, Near, Lateral, Upper };

// An effect is a value type with these members, all noexcept and free of allocation. EffectBank holds and steps them.
// - begin(const EffectInput&): the end-effector has just entered the body
// - Force<HapticBase> step(const EffectInput&, double dt_s): the force on the hand if the device could give any force
// - only springs: Pull pull(double relaxed_m), Force<HapticBase> force(double relaxed_m) and double
//   energy_J(double relaxed_m), all at the depth of the last step. LinearSpring explains relaxed springs.
// - only friction, which is no spring: Force<HapticBase> slip(double relaxed_m) and double energy_J()
// - double stiffest_N_per_m(double most_N): greatest stiffness of its spring at forces up to `most_N`
// - static constexpr const char* kName
// - ObjectTouch touch(): how close the device is to an object inside the body; None for other effects
// - only objects inside the body: Point<HapticBase> place(), the place that the scene gives it. The bank steps such an
//   effect with a device point that is shifted back by the object's displacement.
// - only objects whose wall moves by itself, as an artery's: Vector<HapticBase> wall_velocity(double dt_s), the
//   mean velocity of the wall in the coming tick, relative to place()
// - only layers (the effect Solid): const char* label(), the layer's name in the scene
// - only effects that are no object inside the body: Vector<HapticBase> carried_at(const EffectInput&), the velocity of
//   the surface to which the effect is fixed, for example the breathing skin

}  // namespace telepalp::effects
