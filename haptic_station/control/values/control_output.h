#pragma once

#include "haptic_station/control/phases/phase.h"
#include "proto/words/frames.h"
#include "proto/words/wrench.h"

namespace telepalp::control {

/// The output of one tick of the controller, in H, the haptic base's frame. S1: see docs/sources.md.
struct ControlOutput {
  Phase phase = Phase::Released;
  Phase previous = Phase::Released;  ///< differs from `phase` on the tick of a transition
  Event event = Event::Rearm;        ///< the cause of the transition; meaningless on a tick without a transition
  Force<HapticBase> force;           ///< force for the device, after the limiter
  Torque<HapticBase> torque;         ///< torque for the device, after the limiter; zero for a device without torque
  Point<HapticBase> target;          ///< in Out body: S1's target p_t, eq. (5); else: the end-effector's position
  Point<HapticBase> displayed_hand;  ///< where the viewer draws the hand (S1 II.E)
  Vector<HapticBase> indentation;    ///< S1's d, eq. (8), the depth in the skin as a vector [m]; zero out of contact
  double plane_height_m = 0.0;       ///< y of the plane on which the device waits above the skin
  double passivity_J = 0.0;          ///< PassivityController::balance_J(); negative: the display is active
  double hand_excess_J = 0.0;  ///< work on the hand in this contact minus the measured skin's; HandLedger::excess_J()
  double drive_J = 0.0;  ///< work on the hand since this contact began by the lift, which raises the end-effector from
                         ///< the body, by the position control outside the body and by the recall of workspace indexing
  double yields_in_s = 0.0;             ///< time until heat lowers the contact force; infinite: never, or no contact
  Force<HapticBase> damping;            ///< the part of `force` that the passivity controller added
  double surface_speed_m_per_s = 0.0;   ///< speed of the displayed skin along its normal
  bool limited = false;                 ///< limiter, relaxed springs (spring.h) or a gradual release changed the force
  FaultCause fault = FaultCause::None;  ///< why the phase is Faulted
  FaultCause fault_stands = FaultCause::None;  ///< present cause of a fault; re-arming waits until it ends
};

}  // namespace telepalp::control
