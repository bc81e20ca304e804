#pragma once

#include "haptic_station/control/parts/displayed_hand.h"
#include "haptic_station/control/parts/force_control.h"
#include "haptic_station/control/parts/heat_warning.h"
#include "haptic_station/control/parts/lift.h"
#include "haptic_station/control/parts/phase_machine.h"
#include "haptic_station/control/parts/position_control.h"
#include "haptic_station/control/parts/transition_fade.h"
#include "haptic_station/control/parts/waiting_plane.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/control_output.h"
#include "haptic_station/control/values/encountered_settings.h"
#include "haptic_station/effects/effect_bank.h"

namespace telepalp::control {

/// The controller of an encountered-type device (paper S1 II.D, docs/sources.md). The end-effector waits on a plane
/// above the body, under the free hand. In contact it displays the force of the skin. The force does not jump when a
/// contact begins or ends. The output depends only on the inputs since construction. Real-time safe. Owner: haptic
/// thread.
class EncounteredController {
 public:
  EncounteredController(const ControlSettings& settings, const effects::EffectBank& effects) noexcept
      : settings_(settings),
        phases_(settings.transitions.dwell_s),
        plane_(settings.plane),
        force_control_(effects, settings.coupling, settings.limits.peak_N),
        position_control_(settings.position, settings.transitions.offset_fade_s),
        lift_(settings.position),
        displayed_hand_(settings.transitions.offset_fade_s),
        limiter_(settings.limits) {}

  /// Computes one tick, `dt_s` after the last. `dt_s` is limited to [0, 0.01] s; NaN and infinity count as 0.
  [[nodiscard]] ControlOutput step(const ControlInput& in, double dt_s) noexcept;

  /// Sets the clock that measures the cost of the effects. It must make no system call. nullptr: no measurement.
  void book_costs_with(effects::CostClock clock) noexcept { force_control_.book_costs_with(clock); }
  [[nodiscard]] const effects::EffectBank& effects() const noexcept { return force_control_.effects(); }
  [[nodiscard]] const PassivityController& passivity() const noexcept { return force_control_.passivity(); }
  [[nodiscard]] const VirtualCoupling& coupling() const noexcept { return force_control_.coupling(); }
  [[nodiscard]] Phase phase() const noexcept { return phases_.phase(); }
  /// True when the end-effector was in contact with the skin at the last tick.
  [[nodiscard]] bool touching() const noexcept { return force_control_.touching(); }
  /// The largest slope of an effect's force over depth, up to the greatest force that the limiter gives.
  [[nodiscard]] double stiffest_N_per_m() const noexcept { return effects().stiffest_N_per_m(settings_.limits.peak_N); }
  [[nodiscard]] const ControlSettings& settings() const noexcept { return settings_; }

 private:
  [[nodiscard]] Seen seen_of(const ControlInput& in, FaultCause stands) const noexcept;
  void watch_rise(const ControlInput& in) noexcept;
  void enter_phase(Event event, const ControlInput& in) noexcept;
  [[nodiscard]] bool feels_skin(const ControlInput& in) const noexcept;
  [[nodiscard]] bool inputs_are_stale(const ControlInput& in) const noexcept;
  [[nodiscard]] double owed_N() const noexcept;
  [[nodiscard]] HeldForce phase_force(const ControlInput& in, double dt_s) noexcept;
  [[nodiscard]] double fade_rate_N_per_s() const noexcept;
  [[nodiscard]] Wrench<HapticBase> limited(const HeldForce& wanted, double dt_s) noexcept;
  [[nodiscard]] ControlOutput output() const noexcept;

  ControlSettings settings_;
  PhaseMachine phases_;
  WaitingPlane plane_;
  ForceControl force_control_;
  PositionControl position_control_;
  Lift lift_;
  TransitionFade fade_;
  DisplayedHand displayed_hand_;
  ForceLimiter limiter_;
  HeatWarning heat_warning_;
  bool rises_unfelt_ = false;  ///< below the skin under a hovering hand since the last release: no contact begins
  /// Where position control wanted the end-effector at the last tick (p_t of S1 eq. 5). Outside the phase Out body it
  /// is the end-effector's own position.
  Point<HapticBase> target_;
};

}  // namespace telepalp::control
