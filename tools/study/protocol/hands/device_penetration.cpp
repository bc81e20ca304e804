#include "tools/study/protocol/hands/device_penetration.h"

#include <algorithm>

namespace telepalp::study {

Force<HapticBase> DevicePenetration::step(const loop::GatedReading& reading, double age_s) noexcept {
  if (lost_ != Lost::No) return {};
  if (!(age_s <= kSilent_s)) lost_ = Lost::Silent;
  if (std::max(reading.implausible_s, reading.unreadable_s) > kSilent_s) lost_ = Lost::Implausible;
  if (lost_ != Lost::No) return {};
  const Eigen::Vector3d begin_m = prepared_.tool->on_the_way_m(0.0);
  if (!shift_m_) shift_m_ = begin_m - reading.at.m;
  hand_m_ = reading.at.m + *shift_m_;
  moved_ = moved_ || (hand_m_ - begin_m).norm() > kMoves_m;
  if (!moved_) return {};
  prepared_.insertion->step(hand_m_);
  if (!feels_) return {};
  share_ = std::min(1.0, share_ + kTick_s / kRise_s);
  return {share_ * prepared_.insertion->felt_N()};
}

TrialView DevicePenetration::view() const noexcept {
  const Eigen::Vector3d begin_m = prepared_.tool->on_the_way_m(0.0);
  TrialView view = view_of(prepared_, shift_m_ ? (hand_m_ - begin_m).norm() : 0.0);
  view.moved = moved_;
  view.held_up_s = held_up_s_;
  return view;
}

loop::TickSample DevicePenetration::tick(const Force<HapticBase>& given) const noexcept {
  return tick_of(prepared_, hand_m_, given.N);
}

}  // namespace telepalp::study
