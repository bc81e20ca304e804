#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/loop/body_frame.h"
#include "haptic_station/surface/touch/touch.h"
#include "haptic_station/tracking/hand_estimate.h"

namespace telepalp::loop {

/// How the station compensates delay at one tick: for each compensated quantity, the amount and the uncertainty. No
/// other delay is compensated. Published as msg.StationCompensation.
struct Compensation {
  std::int64_t stamp_ns = 0;             ///< session time of the tick
  std::int64_t surface_captured_ns = 0;  ///< 0: no surface yet

  // The hand: its samples at 100 Hz are predicted to now (paper S1 II.D, docs/sources.md).
  double hand_age_s = 0.0;      ///< age of the newest sample
  double hand_carried_m = 0.0;  ///< distance from that sample to the predicted hand
  double hand_sigma_m = 0.0;    ///< standard deviation of the prediction, per axis

  // The surface: predicted from its capture to now. Displacements are along its normal, positive out of the body.
  double surface_age_s = 0.0;
  double surface_carried_m = 0.0;
  double unmodelled = 0.0;       ///< 1: the skin moves unusually fast, or the camera was pushed; then falls to 0 in 1 s
  double surface_sigma_m = 0.0;  ///< standard deviation of the surface's position, from noise, fit and prediction
  double slewed_m = 0.0;         ///< offset that hides the step from one snapshot to the next; decays to 0
  double coverage = 0.0;         ///< displayed share of the contact force; 0 at rims and on a stale surface

  // The displayed hand, the energy at the hand and the passivity controller.
  double shown_offset_m = 0.0;  ///< from the tracked hand to the displayed hand (S1 II.E)
  double hand_excess_J = 0.0;   ///< work on the hand in this contact except drive_J, minus the measured skin's work
  double drive_J = 0.0;         ///< work on the hand by lift, position control and indexing's recall in this contact
  double damping_N = 0.0;       ///< magnitude of the passivity controller's damping force

  // Counts since the start: jumps of the device's readings that were bridged by extrapolation; samples of the hand that
  // were rejected because they were impossibly fast, out of order or not finite.
  std::uint64_t device_jumps = 0;
  std::uint64_t hand_jumps = 0;

  // The device's own loop and the stiffness that it allows (control/safety/virtual_coupling.h).
  std::optional<double> loop_delay_s = {};  ///< 99th percentile (LoopDelay); nullopt: the device echoes no commands
  double stiffest_shown_N_per_m = 0.0;      ///< the largest stiffness that the device displays stably
  double effects_N_per_m = 0.0;             ///< upper bound of the stiffness of the scene's effects together

  // The objects inside the body, which follow the skin above them; indexed by the number of the effect.
  ObjectPlacements objects{};
};
static_assert(std::is_trivially_copyable_v<Compensation>);

/// The compensation of one tick. `sampled`: the tracker's newest sample, without prediction.
[[nodiscard]] inline Compensation compensation_of(const tracking::HandPrediction& hand,
                                                  const Point<HapticBase>& sampled, const surface::TouchSample& touch,
                                                  const surface::Displaced& displaced,
                                                  const control::ControlOutput& out) noexcept {
  Compensation compensation;
  if (hand.valid) {
    compensation.hand_age_s = hand.age_s;
    compensation.hand_carried_m = (hand.at.m - sampled.m).norm();
    compensation.hand_sigma_m = hand.sigma_m;
    compensation.shown_offset_m = (out.displayed_hand.m - hand.at.m).norm();
  }
  compensation.surface_age_s = touch.age_s;
  compensation.surface_carried_m = displaced.carried_m;
  compensation.unmodelled = touch.unmodelled;
  compensation.surface_sigma_m = touch.uncertainty_m;
  compensation.slewed_m = displaced.slewed_m;
  compensation.coverage = touch.coverage;
  compensation.hand_excess_J = out.hand_excess_J;
  compensation.drive_J = out.drive_J;
  compensation.damping_N = out.damping.N.norm();
  return compensation;
}

}  // namespace telepalp::loop
