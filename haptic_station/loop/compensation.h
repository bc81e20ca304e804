#pragma once

#include <cstdint>
#include <type_traits>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/surface/touch/touch.h"
#include "haptic_station/tracking/hand_estimate.h"

namespace telepalp::station {

/// All that is done about delay at an instant: what is compensated, by how much, and how well that is known. What no
/// line here names is not compensated. Published as msg.StationCompensation.
struct Compensation {
  std::int64_t stamp_ns = 0;             ///< session time of the tick
  std::int64_t surface_captured_ns = 0;  ///< 0: no surface yet

  // The hand: 100 Hz samples, predicted to now (S1 II.D).
  double hand_age_s = 0.0;      ///< since the newest sample
  double hand_carried_m = 0.0;  ///< from that sample to where the hand is taken to be
  double hand_sigma_m = 0.0;    ///< 1-sigma of the prediction, by axis

  // The surface: carried forward from its capture by its own motion, along the normal, outwards positive.
  double surface_age_s = 0.0;
  double surface_carried_m = 0.0;
  double surface_sigma_m = 0.0;  ///< 1-sigma: noise, fit and prediction
  double slewed_m = 0.0;         ///< kept back from the newest snapshot, so that nothing steps; it fades
  double support = 0.0;  ///< share of the contact that is shown: falls to 0 as the surface gets stale, and at rims

  // What the eye and the energy are given for it.
  double shown_offset_m = 0.0;  ///< the drawn hand from the tracked one (S1 II.E)
  double damping_N = 0.0;       ///< part of the force with which the passivity controller takes energy back
};
static_assert(std::is_trivially_copyable_v<Compensation>);

/// Of one tick. `sampled`: the newest sample of the tracker itself.
[[nodiscard]] inline Compensation compensation_of(const tracking::HandPrediction& hand,
                                                  const Point<HapticBase>& sampled, const surface::TouchSample& touch,
                                                  const surface::Displaced& displaced,
                                                  const control::ControlOutput& out) noexcept {
  Compensation told;
  if (hand.valid) {
    told.hand_age_s = hand.age_s;
    told.hand_carried_m = (hand.at.m - sampled.m).norm();
    told.hand_sigma_m = hand.sigma_m;
    told.shown_offset_m = (out.displayed_hand.m - hand.at.m).norm();
  }
  told.surface_age_s = touch.age_s;
  told.surface_carried_m = displaced.carried_m;
  told.surface_sigma_m = touch.uncertainty_m;
  told.slewed_m = displaced.slewed_m;
  told.support = touch.support;
  told.damping_N = out.damping.N.norm();
  return told;
}

}  // namespace telepalp::station
