#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/ports/surface_contact.h"
#include "proto/words/frames.h"

namespace telepalp::control {

/// The input of one tick of the controller. Its output depends on nothing else but its own state.
struct ControlInput {
  Point<HapticBase> device;            ///< position of the end-effector, S1's H_pH_E
  Vector<HapticBase> device_velocity;  ///< [m/s]
  double device_age_s = 0.0;           ///< time since the device last answered
  double device_implausible_s = 0.0;   ///< for how long the device has reported impossibly fast movements; 0: none now
  Point<HapticBase> hand;              ///< position of the hand: tracked, and predicted to now; S1's H_pL_h
  Vector<HapticBase> hand_velocity;    ///< [m/s]
  bool hand_valid = false;             ///< false while the tracker has not seen a hand yet; `hand` is then meaningless
  double hand_age_s = 0.0;             ///< time since the newest sample of the tracker
  double hand_implausible_s = 0.0;     ///< how long the tracker has reported impossibly fast movements; 0: plausible
  ports::SurfaceContact contact;  ///< the surface's answer for `device`; its age is valid even when no surface is near
  effects::Placements placements{};  ///< displacements of the objects inside the body
  bool rearm = false;                ///< true on the tick at which an operator asks to re-arm
};

}  // namespace telepalp::control
