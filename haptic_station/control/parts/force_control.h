#pragma once

#include "haptic_station/control/parts/energy_account.h"
#include "haptic_station/control/parts/sink_in.h"
#include "haptic_station/control/safety/hand_ledger.h"
#include "haptic_station/control/safety/virtual_coupling.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/effects/effect_bank.h"

namespace telepalp::control {

/// Force control (S1 II.D): the scene's effects act on the hand. Effects that are stiffer than the device can show act
/// through the virtual coupling. The energy account keeps them passive. Owner: control thread.
class ForceControl {
 public:
  /// `most_N`: the largest force that the device gives.
  ForceControl(const effects::EffectBank& effects, const CouplingSettings& coupling, double most_N) noexcept
      : effects_(effects), coupling_(coupling, effects.stiffest_N_per_m(most_N)) {}

  /// One tick. `touching`: the hand is in contact with the skin. Returns the force for the device [N]; zero without
  /// contact.
  [[nodiscard]] Eigen::Vector3d step(const ControlInput& in, bool touching, double bound_N, double dt_s) noexcept;

  /// Call after the limiter. `wanted`: the parts of the force that were asked for; `given_N`: what the limiter made of
  /// their sum. The device holds `given_N` until the next step.
  void gave(const HeldForce& wanted, const Eigen::Vector3d& given_N) noexcept;

  /// Fades the contact out (`release`) or in again: the share of the skin's force that is shown goes to 0 or 1 over
  /// `over_s`. Does nothing without contact.
  void release(bool release, double over_s, double dt_s) noexcept;
  [[nodiscard]] bool released() const noexcept { return share_ <= 0.0; }

  /// Sets the clock that measures the cost of the effects. It must make no system call. nullptr: no measurement.
  void book_costs_with(effects::CostClock clock) noexcept { cost_clock_ = clock; }

  [[nodiscard]] bool touching() const noexcept { return touching_; }
  /// True when contact began or ended at the last step.
  [[nodiscard]] bool contact_changed() const noexcept { return contact_changed_; }
  /// True when the device gives another force than the effects ask for.
  [[nodiscard]] bool withholds() const noexcept { return touching_ && account_.withholds(); }
  /// The contact as the hand feels it: after a contact that began at depth, the body is displayed lower.
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
  void begin(const effects::EffectInput& felt) noexcept;
  [[nodiscard]] Eigen::Vector3d feel(effects::EffectInput felt, const Eigen::Vector3d& device_velocity, double bound_N,
                                     double dt_s) noexcept;
  [[nodiscard]] Force<HapticBase> ask_effects(const effects::EffectInput& felt, Exchange& exchange,
                                              double dt_s) noexcept;
  [[nodiscard]] Eigen::Vector3d measured_skin_N(const Eigen::Vector3d& asked_N, double bound_N) const noexcept;

  effects::EffectBank effects_;
  VirtualCoupling coupling_;
  SinkIn sink_in_;
  EnergyAccount account_;
  effects::CostClock cost_clock_ = nullptr;
  ports::SurfaceContact shown_;
  Point<HapticBase> last_felt_;  ///< position of the end-effector in the body's frame at the last step in contact
  HandLedger ledger_;            ///< compares with the newest measured surface
  HeldForce held_;               ///< the force during the last tick
  Eigen::Vector3d moved_m_ = Eigen::Vector3d::Zero();  ///< movement of the end-effector over the last tick, in H
  Point<HapticBase> last_device_;
  double share_ = 1.0;  ///< the part of the skin's force that is shown, 0 to 1
  bool touching_ = false;
  bool contact_changed_ = false;
};

}  // namespace telepalp::control
