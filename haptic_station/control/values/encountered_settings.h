#pragma once

#include "haptic_station/control/safety/force_limiter.h"
#include "haptic_station/control/safety/virtual_coupling.h"

namespace telepalp::control {

/// The plane above the body on which the free end-effector waits (S1 II.D).
struct PlaneSettings {
  double height_m = 0.03;      ///< y of the plane, in H
  double clearance_m = 0.02;   ///< least height of the plane above the skin below the hand
  double offset_m = 0.001;     ///< delta_o of S1 eq. (5): height of the target above the plane
  double speed_m_per_s = 0.1;  ///< greatest speed at which the plane itself rises and sinks
};

struct TransitionSettings {
  double dwell_s = 0.3;              ///< least time in each state (S1)
  double offset_fade_s = 0.15;       ///< time constant with which the offsets of eq. (5) and of the displayed hand fade
  double hand_rose_m = 0.02;         ///< a hand this far above plane and end-effector has left
  double force_fade_N_per_s = 40.0;  ///< rate at which the force of the phase that ended fades
  double contact_release_s = 2.0;    ///< time over which the skin's force fades when the tracker is silent for too long
};

/// The low-level position control of the free end-effector, and the lift away from the body.
struct PositionControlSettings {
  double stiffness_N_per_m = 400.0;
  double damping_N_s_per_m = 25.0;
  double most_N = 3.0;           ///< small enough that a hand can always hold the end-effector
  double fastest_m_per_s = 1.0;  ///< greatest speed of the target
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
  double implausible_s = 0.008;      ///< longest time of impossibly fast device readings; more is a fault
  double hand_implausible_s = 0.08;  ///< the same of hand samples, out of contact
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
