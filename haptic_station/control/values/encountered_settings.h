#pragma once

#include "haptic_station/control/safety/force_limiter.h"
#include "haptic_station/control/safety/virtual_coupling.h"

namespace telepalp::control {

/// The plane above the body on which the free end-effector waits (paper S1 II.D, docs/sources.md).
struct PlaneSettings {
  double height_m = 0.03;      ///< least y of the plane in H, the haptic base's frame
  double clearance_m = 0.02;   ///< least height of the plane above the skin below the end-effector
  double offset_m = 0.001;     ///< delta_o of S1 eq. (5): height of the target above the plane
  double speed_m_per_s = 0.1;  ///< greatest speed at which the plane itself rises and sinks
};

/// Times and rates of the phase transitions. The drawn hand's offset is its distance from the tracked hand: in the body
/// the hand is drawn at the proxy, elsewhere at the tracked position.
struct TransitionSettings {
  double dwell_s = 0.3;              ///< least duration of a phase before a transition marked waits_for_dwell (phase.h)
  double offset_fade_s = 0.15;       ///< decay time constant of S1's Delta p (eq. 5), and of the drawn hand's offset
  double hand_rose_m = 0.02;         ///< a hand this far above the plane and the end-effector has left the end-effector
  double force_fade_N_per_s = 40.0;  ///< rate at which the force difference from a transition decreases to zero
  double contact_release_s = 2.0;    ///< time of the force's fade to 0 after tracker_in_contact_s without a hand sample
};

/// The low-level position control of the free end-effector, and the lift away from the body.
struct PositionControlSettings {
  double stiffness_N_per_m = 100.0;  ///< with this damping, the rate limit causes no swing (position_control.h)
  double damping_N_s_per_m = 12.0;
  double most_N = 3.0;           ///< largest force; a hand can always hold the end-effector against it
  double slew_N_per_s = 90.0;    ///< greatest change of the force of position control: 0.045 N per tick
  double fastest_m_per_s = 1.0;  ///< greatest speed of the hand that the target follows
  double lift_speed_m_per_s = 0.1;
  double lift_damping_N_s_per_m = 15.0;
  double lift_most_N = 1.0;
  double against_hand_N = 0.18;  ///< largest upward force on a hand that comes down onto the end-effector
};

/// Greatest ages of the inputs. When the tracker's sample or the surface is older, the station releases the force
/// (phase Released); when the device's reading is older, it faults.
struct AgeLimits {
  double tracker_s = 0.1;             ///< limit out of contact, where the end-effector follows the tracked hand
  double tracker_in_contact_s = 3.0;  ///< limit in contact, where the force needs no tracker; beyond it the force fades
  double surface_s = 1.0;
  double device_s = 0.1;
  double implausible_s = 0.008;      ///< longest run of impossibly fast device readings; a longer one is a fault
  double unreadable_s = 0.00825;     ///< longest run of readings that are not finite, 16 ticks; then the release
  double hand_implausible_s = 0.08;  ///< longest run of impossibly fast tracker samples out of contact
};

/// Workspace indexing: see loop::WorkspaceIndexing. The defaults are for the device of paper S2 (docs/sources.md),
/// which reaches 0.13 m about its axis, and a body of 1.8 m.
struct IndexingSettings {
  bool on = false;
  double touch_radius_m = 0.1;  ///< radius of an upright cylinder; only a hand inside it feels the body
  double center_x_m = 0.0;      ///< the cylinder's axis, in the device's own frame
  double center_z_m = 0.0;
  double recall_N_per_m = 150.0;  ///< force for each metre beyond the cylinder
  double recall_most_N = 3.0;
  double shift_m_per_s_per_N = 0.05;  ///< speed of the patient's shift for each newton of the recall
  double most_shift_x_m = 0.3;        ///< largest shift along x of H, in either direction
  double most_shift_z_m = 0.9;        ///< largest shift along z of H, in either direction
};

struct ControlSettings {
  PlaneSettings plane;
  TransitionSettings transitions;
  PositionControlSettings position;
  AgeLimits ages;
  ForceLimits limits;
  CouplingSettings coupling;
  IndexingSettings indexing;
};

}  // namespace telepalp::control
