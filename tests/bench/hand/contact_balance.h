#pragma once

#include <array>

#include "tests/bench/hand/run.h"

namespace telepalp::bench::hand {

/// The work that a display gave the hand beyond the law's work on the true skin, along the same path. Counts only while
/// the true or the displayed skin is touched, and only the force of the displayed skin: lift and position control are
/// left out. A contact ends 20 ms after its last touch.
class ContactBalance {
 public:
  /// `displayed_N`: the display's force on the hand over the next tick, in H; zero where it displays no skin.
  void add(const Tick& tick, const Eigen::Vector3d& displayed_N) noexcept;

  /// The most work beyond the law's that the hand had got in a contact, at any instant of it [mJ].
  [[nodiscard]] double most_mJ() const noexcept { return most_mJ_; }
  /// The most work beyond the law's within any 0.2 s [mJ].
  [[nodiscard]] double most_in_window_mJ() const noexcept { return most_in_window_mJ_; }
  [[nodiscard]] double touched_s() const noexcept { return touched_s_; }

 private:
  static constexpr std::size_t kWindowTicks = 400;  // 0.2 s
  Eigen::Vector3d displayed_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d law_N_ = Eigen::Vector3d::Zero();
  std::array<double, kWindowTicks> window_mJ_{};
  std::size_t at_ = 0;
  double in_window_mJ_ = 0.0, most_in_window_mJ_ = 0.0;
  double balance_mJ_ = 0.0, most_mJ_ = 0.0;
  double last_touched_s_ = -1.0;
  double touched_s_ = 0.0;
};

}  // namespace telepalp::bench::hand
