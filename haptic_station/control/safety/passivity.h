#pragma once

#include "proto/words/frames.h"

namespace telepalp::control {

struct PassivitySettings {
  bool enabled = true;
  double most_damping_N_s_per_m = 40.0;
  double tolerance_J = 1e-5;                  ///< excess below it is rounding and quantisation
  double reaction_s = 0.004;                  ///< the damping comes and goes over about so long, for it must not kick
  double hand_most_damping_N_s_per_m = 25.0;  ///< against energy that the moving display gave the hand
  double hand_tolerance_J = 1e-4;             ///< excess at the hand below it is the noise of measured surfaces
  double hand_reaction_s = 0.01;
  double slew_N_per_s = 120.0;  ///< of the damping force: 0.06 N a tick
};

/// What passed between the effects and the hand over one tick.
struct Exchange {
  double absorbed_J = 0.0;             ///< work that the effects took from the hand
  double stored_J = 0.0;               ///< energy in the effects now
  Vector<HapticBase> moved;            ///< of the device, relative to the displayed surface [m]
  Vector<HapticBase> velocity;         ///< of the device, relative to the displayed surface [m/s]
  Vector<HapticBase> device_velocity;  ///< of the device, in H [m/s]
  double hand_excess_J = 0.0;          ///< HandLedger::excess_J()
};

/// Watches two ledgers and damps what either shows too much.
///
/// The ledger of the display: E = -sum F (v - v_displayed) dt, counted from contact, less the energy stored in the
/// effects. A breathing patient does lift the hand, so the displayed surface's own motion is no error here. The effects
/// may store energy but never give out more than they took. The ledger sees what sampling, stiffness and friction leak;
/// it cannot see that the displayed surface itself moves wrongly.
///
/// The ledger at the hand (HandLedger) sees that, against the newest measured surface. Its damping acts on the device's
/// velocity in the room, so that a resting hand feels none of it.
///
/// The damping takes out the excess and no more, and its force never steps. Owner: control thread.
class PassivityController {
 public:
  explicit PassivityController(const PassivitySettings& settings = {}) noexcept : settings_(settings) {}

  /// Contact begins with `stored_J` in the effects, taken as paid for.
  void begin(double stored_J) noexcept;

  /// Books the last tick and answers with the damping force to add for the next, `dt_s` long.
  [[nodiscard]] Force<HapticBase> step(const Exchange& exchange, double dt_s) noexcept;

  /// Energy taken from the hand since the contact began, less what is stored [J]; below zero, the display is active.
  [[nodiscard]] double balance_J() const noexcept { return taken_J_ - stored_J_; }
  /// The least balance since start.
  [[nodiscard]] double least_balance_J() const noexcept { return least_J_; }
  [[nodiscard]] double dissipated_J() const noexcept { return dissipated_J_; }

 private:
  /// A damping coefficient that follows an excess of energy without a step.
  struct Damper {
    double most_N_s_per_m;
    double reaction_s;
    double now_N_s_per_m = 0.0;
    [[nodiscard]] double follow(double excess_J, double speed2_m2_per_s2, double dt_s) noexcept;
  };

  PassivitySettings settings_;
  Force<HapticBase> damping_;  ///< of the tick that ends
  Damper display_{settings_.most_damping_N_s_per_m, settings_.reaction_s};
  Damper hand_{settings_.hand_most_damping_N_s_per_m, settings_.hand_reaction_s};
  double taken_J_ = 0.0;
  double stored_J_ = 0.0;
  double least_J_ = 0.0;
  double dissipated_J_ = 0.0;
};

}  // namespace telepalp::control
