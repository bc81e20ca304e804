#pragma once

#include "haptic_station/ports/surface_contact.h"
#include "proto/words/frames.h"

namespace telepalp::control {

/// Everything that a tick of the controller depends on.
struct ControlInput {
  Point<HapticBase> device;            ///< the end-effector, S1's H_pH_E
  Vector<HapticBase> device_velocity;  ///< [m/s]
  double device_age_s = 0.0;           ///< since the device last answered
  double device_implausible_s = 0.0;   ///< the device has reported movements beyond physics for so long; 0: plausible
  Point<HapticBase> hand;              ///< as tracked and predicted to now, S1's H_pL_h
  Vector<HapticBase> hand_velocity;    ///< [m/s]
  bool hand_valid = false;             ///< false: the tracker has not seen a hand yet; `hand` means nothing
  double hand_age_s = 0.0;             ///< since the newest sample of the tracker
  ports::SurfaceContact contact;       ///< of `device`; its age counts even when no surface is near
  bool rearm = false;                  ///< an operator asks to re-arm, at this tick
};

}  // namespace telepalp::control
