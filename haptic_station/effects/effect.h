#pragma once

#include <array>
#include <cstddef>

#include "haptic_station/ports/surface_contact.h"
#include "proto/words/frames.h"
#include "proto/words/wrench.h"

namespace telepalp::effects {

/// The tool's rotation, as the effects see it.
struct ToolTurn {
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< rotation from the tool's axes to H
  Vector<HapticBase> turned{};                                   ///< rotation vector of the last tick [rad]
  double N_per_N_m = 0.0;  ///< the device's greatest force / its greatest torque [1/m]; 0: it gives no torque
};

/// Inputs of an effect at one tick of the haptic loop.
struct EffectInput {
  Point<HapticBase> device;
  Vector<HapticBase> device_velocity;  ///< [m/s]
  ports::SurfaceContact contact;       ///< surface at the point `device`
  Vector<HapticBase> moved;            ///< motion of the device since the last tick [m]
  ToolTurn turn{};
};

/// Displacement of an object inside the body from the place that the scene gives it, because the body moves.
struct Placement {
  Vector<HapticBase> moved;     ///< [m]
  Vector<HapticBase> velocity;  ///< [m/s]
};
inline constexpr std::size_t kMostEffects = 8;
/// One per effect, in the order in which EffectBank holds the effects.
using Placements = std::array<Placement, kMostEffects>;

/// Up to this distance from an object inside the body, its touch() is Near.
inline constexpr double kAround_m = 0.01;

/// How close the device point is to an object inside the body, in ascending order: not near, within kAround_m, pressed
/// from the side, pressed from above.
enum class ObjectTouch { None, Near, Lateral, Upper };

// An effect is a value type with these members, all noexcept and free of allocation. EffectBank holds and steps them.
// - Settings: its recipe, plain values that a scene gives; the constructor takes them
// An effect without torque may give a Force<HapticBase> where a Wrench<HapticBase> is named here.
// - begin(const EffectInput&): the end-effector has just entered the body
// - Wrench<HapticBase> step(const EffectInput&, double dt_s): the wrench on the hand if the device could give any
// - only springs: Pull pull(double relaxed_m), Wrench<HapticBase> force(double relaxed_m) and double
//   energy_J(double relaxed_m), all at the depth of the last step. LinearSpring explains relaxed springs, and
//   LeverSpring those with a torque.
// - only effects with a state that dissipates energy, as friction's anchor: Wrench<HapticBase> wrench(double relaxed_m,
//   double share), the state's wrench under springs that are relaxed by `relaxed_m`; it may move the state, but only so
//   that the energy stored falls. `share`: part of holds_N() that the state may use. double stored_J(): energy that the
//   hand can get back from the state. Ledgers book what the state takes, and what it still stores; the rest is
//   dissipated. double holds_N(): greatest force of the state, times its weight (LeverSpring); constant in a contact.
//   An effect may be a spring and have a state.
// - only friction of the skin: double coefficient(), in place of holds_N(): its force, across the springs', is at most
//   this share of theirs
// - only effects that damage the skin: double skin_left(), share of its stiffness that is left, 0 to 1, as a needle
//   leaves it. EffectBank multiplies the shares of all effects, and lets the product only fall while a contact lasts.
// - only effects whose force grows with the skin's: void weaken(double skin_left)
// - only effects that depend on the tool's attitude: double loaded_J(const EffectInput&), the energy that they would
//   store with this input, without a change of their state
// - only effects whose forces need a computation that is too slow for a tick: LocalModel, a copyable value, and
//   void take_models(std::shared_ptr<LatestValue<LocalModel>> from), called before the first contact. A slow stage
//   (core/effect_stage.h) puts a model into `from` whenever it has one; step() takes the newest. Before the first one,
//   and when it judges the last one too old, the effect gives no new force. A new model must not add energy to what is
//   stored.
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
