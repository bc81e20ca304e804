#include "tools/study/protocol/browser_trial.h"

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

Vector2d BrowserTrial::along() const noexcept {
  constexpr double kStep_m = 1e-4;
  const Vector3d ahead_m =
      prepared_.tool->on_the_way_m(hand_.way_m() + kStep_m) - prepared_.tool->on_the_way_m(hand_.way_m() - kStep_m);
  return ahead_m.head<2>().normalized();
}

void BrowserTrial::move(const Vector2d& by_m) noexcept { push(by_m.dot(along())); }

void BrowserTrial::step(double seconds) noexcept {
  const double taken_s = std::clamp(seconds, 0.0, kLongestStep_s);
  held_up_s_ += std::max(0.0, seconds - taken_s);
  left_s_ += taken_s;
  const int ticks = static_cast<int>(left_s_ / kTick_s);
  left_s_ -= ticks * kTick_s;
  hand_.begin_step(ticks);
  for (int i = 0; i < ticks && !prepared_.insertion->over(); ++i)
    prepared_.insertion->step(hand_.next_m(*prepared_.insertion));
}

}  // namespace telepalp::study
