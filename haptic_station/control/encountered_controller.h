#pragma once

#include "haptic_station/control/encountered_settings.h"
#include "haptic_station/control/passivity.h"
#include "haptic_station/control/phase.h"
#include "haptic_station/control/phase_event.h"
#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/effects/surface_contact.h"
#include "proto/words/frames.h"

namespace telepalp::control {

/// Everything that a tick depends on.
struct ControlInput {
  Point<HapticBase> device;            ///< the end-effector, S1's H_pH_E
  Vector<HapticBase> device_velocity;  ///< [m/s]
  double device_age_s = 0.0;           ///< since the device last answered
  Point<HapticBase> hand;              ///< as tracked and predicted to now, S1's H_pL_h
  Vector<HapticBase> hand_velocity;    ///< [m/s]
  bool hand_valid = false;
  double hand_age_s = 0.0;          ///< since the newest sample of the tracker
  effects::SurfaceContact contact;  ///< of `device`; age_s counts even when there is no surface near
  bool rearm = false;               ///< an operator asks for it, for this tick
};

struct ControlOutput {
  Phase phase = Phase::Released;
  Phase previous = Phase::Released;  ///< differs from `phase` on the tick of a transition
  Event event = Event::Rearm;        ///< what made the transition; meaningless without one
  Force<HapticBase> force;           ///< for the device, and so on the hand: after the limiter
  Point<HapticBase> target;          ///< S1's p_t, eq. (5); the end-effector itself but in Out body
  Point<HapticBase> displayed_hand;  ///< where the viewer draws the hand (S1 II.E)
  Vector<HapticBase> indentation;    ///< S1's d, eq. (8); zero out of the body
  double plane_height_m = 0.0;
  double passivity_J = 0.0;                    ///< balance of the passivity ledger
  Force<HapticBase> damping;                   ///< part of `force` that the passivity controller added
  double surface_speed_m_per_s = 0.0;          ///< of the skin as felt, along its normal
  bool limited = false;                        ///< the limiter changed the force
  FaultCause fault = FaultCause::None;         ///< why it is Faulted
  FaultCause fault_stands = FaultCause::None;  ///< what would fault this very tick; nothing can be re-armed before
};

/// S1 II.D: lets the end-effector wait on a plane above the body under the free hand, become the skin at contact, and
/// part without a jump. Pure: what it answers depends on its inputs since construction alone. Real-time safe.
/// Owner: control thread.
class EncounteredController {
 public:
  EncounteredController(const ControlSettings& settings, const effects::EffectBank& effects) noexcept
      : settings_(settings),
        effects_(effects),
        limiter_(settings.limits),
        coupling_(settings.coupling, effects.stiffest_N_per_m(settings.limits.peak_N)) {}

  /// One tick, `dt_s` after the last.
  [[nodiscard]] ControlOutput step(const ControlInput& in, double dt_s) noexcept;

  /// A clock without system calls to book the effects' cost with; nullptr: none.
  void book_costs_with(effects::CostClock clock) noexcept { cost_clock_ = clock; }
  [[nodiscard]] const effects::EffectBank& effects() const noexcept { return effects_; }
  [[nodiscard]] const PassivityController& passivity() const noexcept { return passivity_; }
  [[nodiscard]] const VirtualCoupling& coupling() const noexcept { return coupling_; }
  [[nodiscard]] Phase phase() const noexcept { return phase_; }

 private:
  /// A value and its rate.
  struct Moving {
    Eigen::Vector3d m = Eigen::Vector3d::Zero();
    Eigen::Vector3d per_s = Eigen::Vector3d::Zero();
  };

  [[nodiscard]] FaultCause standing_fault(const ControlInput& in) const noexcept;
  [[nodiscard]] Seen seen_of(const ControlInput& in, FaultCause stands) const noexcept;
  void rearm() noexcept;
  void move_plane(const ControlInput& in, double dt_s) noexcept;
  void enter(Phase phase, const ControlInput& in) noexcept;
  void sink_in(ControlInput& in, bool begins, double dt_s) noexcept;
  [[nodiscard]] effects::EffectInput as_the_body_sees(const ControlInput& in) const noexcept;
  void begin_contact(const ControlInput& in) noexcept;
  Eigen::Vector3d effects_force_N(const ControlInput& in, double dt_s) noexcept;
  Eigen::Vector3d position_force_N(const ControlInput& in, double dt_s) noexcept;
  [[nodiscard]] Eigen::Vector3d lift_force_N(const ControlInput& in) const noexcept;
  Eigen::Vector3d faded_N(const Eigen::Vector3d& raw_N, bool starts_anew, double dt_s) noexcept;
  Point<HapticBase> shown_hand(const ControlInput& in, double dt_s) noexcept;

  ControlSettings settings_;
  effects::EffectBank effects_;
  ForceLimiter limiter_;
  PassivityController passivity_;
  VirtualCoupling coupling_;
  effects::CostClock cost_clock_ = nullptr;

  Phase phase_ = Phase::Released;
  FaultCause fault_ = FaultCause::None;
  double in_phase_s_ = 0.0;
  bool touching_ = false;  ///< the effects are being stepped
  double plane_height_m_ = 0.0;
  bool plane_placed_ = false;
  Moving hand_;    ///< the hand, smoothed over the tracker's updates
  Moving offset_;  ///< Delta p of S1 eq. (5), fading
  Eigen::Vector3d position_force_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d wanted_N_ = Eigen::Vector3d::Zero();  ///< last tick, before the limiter
  Eigen::Vector3d fading_N_ = Eigen::Vector3d::Zero();  ///< what is left of a force that a transition ended
  Point<HapticBase> shown_;
  Eigen::Vector3d shown_offset_m_ = Eigen::Vector3d::Zero();
  bool shown_from_proxy_ = false;
  Point<HapticBase> last_proxy_;
  Force<HapticBase> damping_;
  Eigen::Vector3d withheld_N_ = Eigen::Vector3d::Zero();  ///< given less asked by the effects, over the tick that ends
  Point<HapticBase> target_;
  Point<HapticBase> last_felt_;  ///< the end-effector as the effects saw it last
  double unpaid_depth_m_ = 0.0;  ///< at which the contact began, not yet shown
  double rising_m_per_s_ = 0.0;  ///< at which it is being shown
};

}  // namespace telepalp::control
