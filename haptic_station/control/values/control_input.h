#pragma once

#include <optional>

#include "haptic_station/effects/effect.h"
#include "haptic_station/ports/readings.h"
#include "haptic_station/ports/surface_contact.h"
#include "proto/words/frames.h"

namespace telepalp::control {

/// The input of one tick of the controller. The controller's output depends only on this and on its own state.
/// Positions are in H, the haptic base's frame. S1: see docs/sources.md.
struct ControlInput {
  Point<HapticBase> device;            ///< position of the end-effector; written H_pH_E in S1
  Vector<HapticBase> device_velocity;  ///< [m/s]
  double device_age_s = 0.0;           ///< time since the device last answered
  double device_implausible_s = 0.0;   ///< how long the device has moved impossibly fast; 0: plausible
  double device_unreadable_s = 0.0;    ///< how long the device's readings have not been finite; 0: this one is
  Point<HapticBase> hand;              ///< tracked position of the hand, predicted to now; written H_pL_h in S1
  Vector<HapticBase> hand_velocity;    ///< [m/s]
  bool hand_valid = false;             ///< false while the tracker has not seen a hand yet; `hand` is then meaningless
  double hand_age_s = 0.0;             ///< time since the newest sample of the tracker
  double hand_implausible_s = 0.0;     ///< how long the tracker has reported impossibly fast movements; 0: plausible
  ports::SurfaceContact contact;       ///< contact of `device`; its age_s is valid even if no surface is near
  effects::Placements placements{};    ///< displacements of the objects inside the body
  bool interacts = true;               ///< false: the hand is beyond the touch cylinder, so the body gives no force
  Force<HapticBase> recall;            ///< force of workspace indexing; added to the force of the phase
  Vector<HapticBase> reindexed;  ///< shift by workspace indexing in this tick, contained in the motion of `device` [m]
  std::optional<double> wait_at_m;  ///< height y at which the free end-effector waits; nullopt: on the scene's plane
  /// Rotation from the tool's axes to H, a unit quaternion; nullopt: the device does not measure it.
  std::optional<Eigen::Quaterniond> attitude = {};
  Vector<HapticBase> turning{};   ///< angular velocity of the tool [rad/s]; counts only with `attitude`
  ports::DevicePower power = {};  ///< the device's greatest force and torque
  double loop_delay_s = 0.0;      ///< delay of the device's loop (loop::LoopDelay); 0: unknown
  bool rearm = false;             ///< true on the tick at which an operator asks to re-arm
};

}  // namespace telepalp::control
