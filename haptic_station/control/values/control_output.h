#pragma once

#include "haptic_station/control/phases/phase.h"
#include "proto/words/frames.h"

namespace telepalp::control {

/// What the controller decided at a tick.
struct ControlOutput {
  Phase phase = Phase::Released;
  Phase previous = Phase::Released;  ///< differs from `phase` on the tick of a transition
  Event event = Event::Rearm;        ///< the cause of the transition; without a transition it means nothing
  Force<HapticBase> force;           ///< for the device, and so on the hand: after the limiter
  Point<HapticBase> target;          ///< S1's p_t, eq. (5), in Out body; the end-effector itself in other phases
  Point<HapticBase> displayed_hand;  ///< where the viewer draws the hand (S1 II.E)
  Vector<HapticBase> indentation;    ///< S1's d, eq. (8); zero out of the body
  double plane_height_m = 0.0;
  double passivity_J = 0.0;                    ///< balance of the passivity ledger
  double hand_excess_J = 0.0;                  ///< HandLedger::excess_J() of this contact, against the measured skin
  double drive_J = 0.0;                        ///< work on the hand by lift and position control since it began
  double yields_in_s = 0.0;                    ///< until warm motors lower the force in contact; infinite: they do not
  Force<HapticBase> damping;                   ///< part of `force` that the passivity controller added
  double surface_speed_m_per_s = 0.0;          ///< of the skin as felt, along its normal
  bool limited = false;                        ///< the limiter changed the force
  FaultCause fault = FaultCause::None;         ///< why the phase is Faulted
  FaultCause fault_stands = FaultCause::None;  ///< would fault this very tick; re-arming has to wait until it ends
};

}  // namespace telepalp::control
