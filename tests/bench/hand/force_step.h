#pragma once

#include <algorithm>
#include <optional>

#include "tests/bench/hand/run.h"

namespace telepalp::bench::hand {

/// The largest change of the force in one tick that the hand's motion does not explain. The 10 ms after a true change
/// of contact are left out.
class ForceSteps {
 public:
  void add(const Tick& tick, double stiffness_N_per_m = kSkin_N_per_m) noexcept {
    const bool inside = tick.true_known && tick.true_depth_m > 0.0;
    if (inside != inside_) changed_s_ = tick.time_s;
    inside_ = inside;
    const double explained_N = stiffness_N_per_m * tick.moved_m.norm();
    const double step_N = before_N_ ? (tick.force_N - *before_N_).norm() - explained_N : 0.0;
    before_N_ = tick.force_N;
    constexpr double kAfter_s = 0.01;
    if (tick.time_s - changed_s_ < kAfter_s || tick.time_s < kSettles_s) return;
    worst_N_ = std::max(worst_N_, step_N);
  }
  [[nodiscard]] double worst_N() const noexcept { return worst_N_; }

 private:
  static constexpr double kSettles_s = 0.1;
  std::optional<Eigen::Vector3d> before_N_;  ///< nullopt: before the first tick
  double changed_s_ = -1.0;
  double worst_N_ = 0.0;
  bool inside_ = false;
};

}  // namespace telepalp::bench::hand
