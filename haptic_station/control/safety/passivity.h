#pragma once

#include "proto/words/frames.h"
#include "proto/words/wrench.h"

namespace telepalp::control {

/// Energy and motion between the effects and the hand over one tick. H is the haptic base's frame.
struct Exchange {
  double absorbed_J = 0.0;             ///< work that the effects took from the hand
  double stored_J = 0.0;               ///< energy in the effects now
  Vector<HapticBase> moved;            ///< movement of the device relative to the displayed surface [m]
  Vector<HapticBase> velocity;         ///< velocity of the device relative to the displayed surface [m/s]
  Vector<HapticBase> device_velocity;  ///< velocity of the device in H [m/s]
  Vector<HapticBase> turned;           ///< rotation of the tool that the effects see [rad]
  Vector<HapticBase> turning;          ///< angular velocity of this tool [rad/s]
  /// Greatest torque per newton of greatest force [m]. The damping counts an angular velocity as this lever times it.
  /// 0: no torque is displayed.
  double lever_m = 0.0;
  double force_change_N = 0.0;  ///< change of the effects' force since the last tick, a magnitude
  double hand_excess_J = 0.0;   ///< HandLedger::excess_J(): work on the hand beyond the measured skin's
};

/// Reads two energy ledgers and adds damping when either shows an excess of energy: the passivity observer and
/// passivity controller of Hannaford and Ryu (2002).
///
/// The ledger of the display: E = -sum F (v - v_displayed) dt since the contact began, minus the energy stored in the
/// effects; F: force on the hand, v: velocity of the device, v_displayed: velocity of the displayed surface. A torque
/// counts in the same way, with the angular velocity of the tool, as far as it is displayed. A
/// breathing patient may lift the hand, so the work of the moving surface is not counted. The effects may store energy
/// but must never return more than they took. This ledger detects the energy that sampling, stiffness and friction
/// create. It cannot detect the energy from a displayed surface that moves differently from the patient.
///
/// The ledger at the hand (HandLedger) detects that energy: it compares the work on the hand with the work that the
/// newest measured surface would have done. Its damping acts on the device's velocity in H, so a resting hand feels
/// none.
///
/// The damping stops when the excess is gone. Its force changes slowly in a tick in which the effects' force steps, so
/// that both together make a smaller step (kSlew_N_per_s in passivity.cpp). Owner: haptic thread.
class PassivityController {
 public:
  /// Contact begins. `stored_J`: energy that the effects store at that time; it counts as already taken from the hand.
  void begin(double stored_J) noexcept;

  /// Adds the last tick to the balance and returns the damping to add for the next tick of `dt_s`.
  [[nodiscard]] Wrench<HapticBase> step(const Exchange& exchange, double dt_s) noexcept;

  /// Energy taken from the hand since the contact began, minus the stored energy [J]; negative: the display is active.
  [[nodiscard]] double balance_J() const noexcept { return taken_J_ - stored_J_; }
  /// The smallest balance since construction [J].
  [[nodiscard]] double least_balance_J() const noexcept { return least_J_; }
  [[nodiscard]] double dissipated_J() const noexcept { return dissipated_J_; }  ///< by the damping, since construction

 private:
  /// A damping coefficient that grows and falls gradually with the excess of energy.
  struct Damper {
    double most_N_s_per_m;
    double reaction_s;  ///< time to remove an excess; the damping takes as long to rise from 0 to its limit
    double now_N_s_per_m = 0.0;
    [[nodiscard]] double follow(double excess_J, double speed2_m2_per_s2, double dt_s) noexcept;
  };

  Wrench<HapticBase> damping_;  ///< during the last tick
  Damper display_{.most_N_s_per_m = 40.0, .reaction_s = 0.004};
  Damper hand_{.most_N_s_per_m = 25.0, .reaction_s = 0.01};  ///< against an excess in HandLedger
  double taken_J_ = 0.0;
  double stored_J_ = 0.0;
  double least_J_ = 0.0;
  double dissipated_J_ = 0.0;
};

}  // namespace telepalp::control
