#include "clients/mixed/compose/camouflage.h"

#include <algorithm>

#include "proto/words/smooth_step.h"

namespace telepalp::mixed {
namespace {

bool is_doubted(const PictureTrust& trust) noexcept {
  return trust.fault || !trust.markers_seen || !(trust.image_age_s <= kOldImage_s);
}

CamouflageState faded(CamouflageState state, double step_s) noexcept {
  if (state.phase == Camouflage::Hiding) state.opacity = std::min(1.0, state.opacity + step_s / kHideIn_s);
  if (state.phase == Camouflage::Revealing) state.opacity = std::max(0.0, state.opacity - step_s / kRevealIn_s);
  const bool ended = (state.phase == Camouflage::Hiding && state.opacity >= 1.0) ||
                     (state.phase == Camouflage::Revealing && state.opacity <= 0.0);
  if (ended) state.phase = next(state.phase, PictureEvent::FadeEnded);
  return state;
}

}  // namespace

CamouflageState advance(CamouflageState state, const PictureTrust& trust, double step_s) noexcept {
  if (is_doubted(trust)) {
    state.trusted_for_s = 0.0;
    state.phase = next(state.phase, PictureEvent::Doubted);
  } else if (trust.image_age_s < kFreshImage_s) {
    state.trusted_for_s += step_s;
  }
  if (state.trusted_for_s >= kTrustAfter_s) state.phase = next(state.phase, PictureEvent::Trusted);
  return faded(state, step_s);
}

double ghost_opacity(double hand_m, double joint_share) noexcept {
  constexpr double kHandSeesNothing_m = 0.15, kHandSeesAll_m = 0.05;
  constexpr double kEndSeesNothing = 0.1, kEndSeesAll = 0.02;
  return std::max(smooth_step(kHandSeesNothing_m, kHandSeesAll_m, hand_m),
                  smooth_step(kEndSeesNothing, kEndSeesAll, joint_share));
}

}  // namespace telepalp::mixed
