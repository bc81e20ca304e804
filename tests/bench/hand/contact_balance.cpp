#include "tests/bench/hand/contact_balance.h"

#include <algorithm>

namespace telepalp::bench::hand {

void ContactBalance::add(const Tick& tick, const Eigen::Vector3d& displayed_N) noexcept {
  constexpr double kEndsAfter_s = 0.02;
  const bool in_contact = tick.time_s - last_touched_s_ < kEndsAfter_s;
  // While the device moved, it held the force of the previous tick.
  const double given_mJ = in_contact ? 1e3 * (displayed_N_ - law_N_).dot(tick.moved_m) : 0.0;
  in_window_mJ_ += given_mJ - window_mJ_[at_];
  window_mJ_[at_] = given_mJ;
  at_ = (at_ + 1) % kWindowTicks;
  most_in_window_mJ_ = std::max(most_in_window_mJ_, in_window_mJ_);
  balance_mJ_ = in_contact ? balance_mJ_ + given_mJ : 0.0;
  most_mJ_ = std::max(most_mJ_, balance_mJ_);
  displayed_N_ = displayed_N;
  law_N_ = tick.law_N() * tick.normal;
  if (displayed_N.squaredNorm() <= 0.0 && tick.law_N() <= 0.0) return;
  last_touched_s_ = tick.time_s;
  touched_s_ += kTick_s;
}

}  // namespace telepalp::bench::hand
