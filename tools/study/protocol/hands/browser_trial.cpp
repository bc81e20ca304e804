#include "tools/study/protocol/hands/browser_trial.h"

#include <algorithm>
#include <cmath>

namespace telepalp::study {

using Eigen::Vector2d;
using Eigen::Vector3d;

void BrowserHand::push(double way_m) noexcept {
  if (std::isfinite(way_m)) aim_m_ = std::clamp(aim_m_ + way_m, kLeast_m, kMost_m);
}

void BrowserHand::begin_step(int ticks) noexcept {
  const double most_m = kFastest_m_per_s * kTick_s;
  each_tick_m_ = std::clamp((aim_m_ - way_m_) / std::max(ticks, 1), -most_m, most_m);
}

Vector3d BrowserHand::next_m(const Insertion& insertion) noexcept {
  way_m_ += each_tick_m_;
  const Vector3d shown_N = feels(condition_) ? insertion.felt_N() : Vector3d(Vector3d::Zero());
  arm_.step(insertion.tool().on_the_way_m(way_m_), shown_N);
  return arm_.hand_m();
}

void BrowserTrial::push(double way_m) noexcept {
  moved_ = true;
  hand_.push(way_m);
}

void BrowserTrial::move(const Vector2d& by_m) noexcept { push(by_m.dot(view_of(prepared_, hand_.way_m()).along)); }

TrialView BrowserTrial::view() const noexcept {
  TrialView view = view_of(prepared_, hand_.way_m());
  view.moved = moved_;
  view.held_up_s = held_up_s_;
  return view;
}

void BrowserTrial::step(double seconds, Ticks& ticks) {
  const double taken_s = std::clamp(seconds, 0.0, kLongestStep_s);
  held_up_s_ += std::max(0.0, seconds - taken_s);
  left_s_ += taken_s;
  const int due = static_cast<int>(left_s_ / kTick_s);
  left_s_ -= due * kTick_s;
  hand_.begin_step(due);
  for (int i = 0; i < due && !prepared_.insertion->over(); ++i) {
    const Vector3d hand_m = hand_.next_m(*prepared_.insertion);
    prepared_.insertion->step(hand_m);
    ticks.push_back(
        tick_of(prepared_, hand_m, feels(condition_) ? prepared_.insertion->felt_N() : Vector3d(Vector3d::Zero())));
  }
}

}  // namespace telepalp::study
