#pragma once

#include "haptic_station/control/parts/energy_account.h"
#include "haptic_station/control/parts/sink_in.h"
#include "haptic_station/control/safety/hand_ledger.h"
#include "haptic_station/control/safety/virtual_coupling.h"
#include "haptic_station/control/safety/virtual_tool.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/effects/effect_bank.h"

namespace telepalp::control {

/// Force control (paper S1 II.D, docs/sources.md): the scene's effects act on the hand. If they are stiffer than the
/// device can display stably, they act through the virtual coupling. EnergyAccount adds damping to keep them passive.
/// Owner: haptic thread.
class ForceControl {
 public:
  /// `most_N`: the largest force that the device gives.
  ForceControl(const effects::EffectBank& effects, const CouplingSettings& coupling, double most_N) noexcept
      : effects_(effects), coupling_(coupling, effects.stiffest_N_per_m(most_N)) {}

  /// Computes one tick. `touching`: the hand is in contact with the skin. `bound_N`: upper bound of the effects' force,
  /// without the damping: the limiter's present peak force or, in the phases Released and Faulted, the magnitude of the
  /// force that the device still gives. `lever_m`: greatest torque per newton of greatest force; 0: the device gives no
  /// torque. Returns the wrench for the device; zero without contact.
  [[nodiscard]] Wrench<HapticBase> step(const ControlInput& in, bool touching, double bound_N, double lever_m,
                                        double dt_s) noexcept;

  /// Call after the limiter. `wanted`: the parts of the limiter's input. `given`: the limiter's output, which the
  /// device applies until the next step.
  void gave(const HeldForce& wanted, const Wrench<HapticBase>& given) noexcept;
  /// Magnitude of the force that the device applies until the next step.
  [[nodiscard]] double given_N() const noexcept { return (held_.skin + held_.fade + held_.drive).norm(); }

  /// Moves the displayed share of the effects' force towards 0 (`release`) or back towards 1. The full range takes
  /// `over_s`. Does nothing without contact.
  void release(bool release, double over_s, double dt_s) noexcept;
  [[nodiscard]] bool released() const noexcept { return share_ <= 0.0; }

  /// Sets the clock that measures the cost of the effects. It must make no system call. nullptr: no measurement.
  void book_costs_with(effects::CostClock clock) noexcept { cost_clock_ = clock; }

  [[nodiscard]] bool touching() const noexcept { return touching_; }
  /// True when contact began or ended at the last step.
  [[nodiscard]] bool contact_changed() const noexcept { return contact_changed_; }
  /// True when the force of the device differs from the one that the effects and the damping ask for.
  [[nodiscard]] bool withholds() const noexcept {
    return touching_ && (effects_.relaxed_m() > 0.0 || account_.withholds());
  }
  /// The contact with the displayed skin. If it began below the skin, the displayed skin is lowered at first; see
  /// SinkIn.
  [[nodiscard]] const ports::SurfaceContact& shown() const noexcept { return shown_; }
  [[nodiscard]] Force<HapticBase> damping() const noexcept {
    return touching_ ? account_.damping() : Force<HapticBase>{};
  }
  [[nodiscard]] Vector<HapticBase> indentation() const noexcept {
    return touching_ ? effects_.indentation() : Vector<HapticBase>{};
  }
  [[nodiscard]] const effects::EffectBank& effects() const noexcept { return effects_; }
  [[nodiscard]] const PassivityController& passivity() const noexcept { return account_.passivity(); }
  [[nodiscard]] const HandLedger& hand_ledger() const noexcept { return ledger_; }
  [[nodiscard]] const VirtualCoupling& coupling() const noexcept { return coupling_; }

 private:
  void begin(effects::EffectInput felt, const ControlInput& in, double lever_m) noexcept;
  [[nodiscard]] Wrench<HapticBase> feel(effects::EffectInput felt, const ControlInput& in, double bound_N,
                                        double lever_m, double dt_s) noexcept;
  [[nodiscard]] Wrench<HapticBase> ask_effects(const effects::EffectInput& felt, const ControlInput& in,
                                               Exchange& exchange, double bound_N, double dt_s) noexcept;
  [[nodiscard]] Eigen::Vector3d measured_skin_N(const Eigen::Vector3d& asked_N, double bound_N) const noexcept;

  effects::EffectBank effects_;
  VirtualCoupling coupling_;
  VirtualTool tool_;
  double N_per_N_m_ = 0.0;  ///< of the device, at the beginning of the contact (effects::ToolTurn)
  SinkIn sink_in_;
  EnergyAccount account_;
  effects::CostClock cost_clock_ = nullptr;
  ports::SurfaceContact shown_;
  Point<HapticBase> last_felt_;  ///< end-effector relative to the lowered body (see SinkIn) at the last step in contact
  HandLedger ledger_;            ///< its reference: the newest captured surface, predicted to now
  HeldForce held_;               ///< the force that the device applied over the last tick
  Eigen::Vector3d moved_m_ = Eigen::Vector3d::Zero();  ///< movement of the end-effector over the last tick
  Point<HapticBase> last_device_;
  double share_ = 1.0;  ///< displayed share of the effects' force, 0 to 1
  bool touching_ = false;
  bool contact_changed_ = false;
};

}  // namespace telepalp::control
