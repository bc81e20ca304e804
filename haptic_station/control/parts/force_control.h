#pragma once

#include "haptic_station/control/parts/energy_account.h"
#include "haptic_station/control/parts/sink_in.h"
#include "haptic_station/control/safety/hand_ledger.h"
#include "haptic_station/control/safety/virtual_coupling.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/effects/effect_bank.h"

namespace telepalp::control {

/// Force control (S1 II.D): the effects that the scene names act on the hand, through the virtual coupling where they
/// are stiffer than the device can show, with their energy accounted for. Owner: control thread.
class ForceControl {
 public:
  /// `most_N`: the largest force that the device gives.
  ForceControl(const effects::EffectBank& effects, const CouplingSettings& coupling, double most_N) noexcept
      : effects_(effects), coupling_(coupling, effects.stiffest_N_per_m(most_N)) {}

  /// One tick with (`touching`) or without contact with the skin. The force for the device [N]; zero without contact.
  [[nodiscard]] Eigen::Vector3d step(const ControlInput& in, bool touching, double bound_N, double dt_s) noexcept;

  /// The whole force on the device until the next step: its parts as wanted, and the limiter's answer to their sum.
  void gave(const HeldForce& wanted, const Eigen::Vector3d& given_N) noexcept;

  /// The contact is let go of gently (`release`), or taken up again: the share of the skin's force that is shown goes
  /// to 0 or 1 over `over_s`. Without contact nothing happens.
  void release(bool release, double over_s, double dt_s) noexcept;
  [[nodiscard]] bool released() const noexcept { return share_ <= 0.0; }

  /// A clock without system calls to measure the effects' cost with; nullptr: their cost is not measured.
  void book_costs_with(effects::CostClock clock) noexcept { cost_clock_ = clock; }

  [[nodiscard]] bool touching() const noexcept { return touching_; }
  /// Contact began or ended at the last step.
  [[nodiscard]] bool contact_changed() const noexcept { return contact_changed_; }
  /// True when the device gives another force than the effects ask for.
  [[nodiscard]] bool withholds() const noexcept { return touching_ && account_.withholds(); }
  /// The contact as the hand feels it: with the body shown lower after a contact that began at depth.
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
  Point<HapticBase> last_felt_;  ///< the end-effector in the body's frame, at the last step in contact
  HandLedger ledger_;            ///< against the newest measured surface
  HeldForce held_;               ///< over the tick that ends
  Eigen::Vector3d moved_m_ = Eigen::Vector3d::Zero();  ///< of the end-effector in H, over the tick that ends
  Point<HapticBase> last_device_;
  double share_ = 1.0;  ///< of the skin's force that is shown
  bool touching_ = false;
  bool contact_changed_ = false;
};

}  // namespace telepalp::control
