#include "haptic_station/control/parts/displayed_hand.h"

#include <cmath>

namespace telepalp::control {

Point<HapticBase> DisplayedHand::step(const ControlInput& in, const ports::SurfaceContact& contact, bool inside,
                                      double dt_s) noexcept {
  if (contact.valid) last_proxy_ = contact.proxy;
  const Eigen::Vector3d base = inside ? last_proxy_.m : (in.hand_valid ? in.hand.m : at_.m);
  if (inside != inside_) offset_m_ = at_.m - base;
  inside_ = inside;
  if (!inside && !in.hand_valid) offset_m_.setZero();
  offset_m_ *= left_.of(-dt_s / fade_s_);
  at_.m = base + offset_m_;
  return at_;
}

}  // namespace telepalp::control
