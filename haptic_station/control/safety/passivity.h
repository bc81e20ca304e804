#pragma once

#include "proto/words/frames.h"

namespace telepalp::control {

struct PassivitySettings {
  bool enabled = true;
  double most_damping_N_s_per_m = 40.0;
  double tolerance_J = 1e-5;  ///< excess below it is rounding and quantisation
  double reaction_s = 0.004;  ///< the damping comes and goes over about so long, for it must not kick
};

/// What passed between the effects and the hand over one tick.
struct Exchange {
  double absorbed_J = 0.0;      ///< work that the effects took from the hand
  double stored_J = 0.0;        ///< energy in the effects now
  Vector<HapticBase> moved;     ///< of the device, relative to the surface [m]
  Vector<HapticBase> velocity;  ///< of the device, relative to the surface [m/s]
};

/// Watches the energy that the effects give to the hand, and damps what should not be there.
///
/// The ledger is the work that the hand has done on the display, E = -sum F (v - v_surface) dt, counted from contact.
/// Velocity is relative to what pushes: a breathing patient really does lift the hand, and that is no error. The
/// effects may store energy but never give out more than they took: E - U(stored) >= 0. What is below is the excess
/// energy, and the damping takes out that and no more. Owner: control thread.
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
  PassivitySettings settings_;
  Force<HapticBase> damping_;  ///< of the tick that ends
  double coefficient_N_s_per_m_ = 0.0;
  double taken_J_ = 0.0;
  double stored_J_ = 0.0;
  double least_J_ = 0.0;
  double dissipated_J_ = 0.0;
};

}  // namespace telepalp::control
