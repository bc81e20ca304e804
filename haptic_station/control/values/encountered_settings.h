#pragma once

#include "haptic_station/control/safety/force_limiter.h"
#include "haptic_station/control/safety/virtual_coupling.h"

namespace telepalp::control {

/// The plane above the body on which the free end-effector waits (S1 II.D).
struct PlaneSettings {
  double height_m = 0.03;      ///< of the plane, in H
  double clearance_m = 0.02;   ///< the plane stays at least so far above the skin below the hand
  double offset_m = 0.001;     ///< delta_o of S1 eq. (5): the target is held so far above the plane
  double speed_m_per_s = 0.1;  ///< at which the plane itself may rise and sink
};

struct TransitionSettings {
  double dwell_s = 0.3;              ///< S1: at least so long in each state
  double offset_fade_s = 0.15;       ///< time constant of the fading offsets: eq. (5)'s and the shown hand's
  double hand_rose_m = 0.02;         ///< so far above plane and end-effector, a hand has left
  double force_fade_N_per_s = 40.0;  ///< a force that a transition ends fades at this rate
  double contact_release_s = 2.0;    ///< the skin fades over this time when the tracker is silent for too long
};

/// The low-level position control of the free end-effector, and the lift away from the body.
struct PositionControlSettings {
  double stiffness_N_per_m = 400.0;
  double damping_N_s_per_m = 25.0;
  double most_N = 3.0;           ///< a hand can always hold the end-effector
  double fastest_m_per_s = 1.0;  ///< of the target
  double lift_speed_m_per_s = 0.1;
  double lift_damping_N_s_per_m = 15.0;
  double lift_most_N = 1.0;
};

/// An input that is older than its limit counts as missing.
struct AgeLimits {
  double tracker_s = 0.1;             ///< out of the body, where the end-effector follows the tracked hand
  double tracker_in_contact_s = 3.0;  ///< in contact, where the skin's force depends on the device alone
  double surface_s = 1.0;
  double device_s = 0.1;
  double implausible_s = 0.008;  ///< of device readings beyond physics; longer is a fault
};

struct ControlSettings {
  PlaneSettings plane;
  TransitionSettings transitions;
  PositionControlSettings position;
  AgeLimits ages;
  ForceLimits limits;
  CouplingSettings coupling;
};

}  // namespace telepalp::control
