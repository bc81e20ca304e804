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

double ghost_opacity(double joint_share) noexcept {
  constexpr double kSeesNothing = 0.1, kSeesAll = 0.02;
  return smooth_step(kSeesNothing, kSeesAll, joint_share);
}

}  // namespace telepalp::mixed
