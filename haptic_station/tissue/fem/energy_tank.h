#pragma once

#include <algorithm>

namespace telepalp::tissue {

/// Books the energy that changes of a local model add to a spring or take out of it (Franken and others 2011). What a
/// change takes out fills the tank, and what a change adds is paid from it. So all changes together add at most the
/// level at the beginning. The level is never negative, and never above what the tank holds; the surplus is lost.
class EnergyTank {
 public:
  explicit EnergyTank(double level_J = 0.0, double holds_J = 0.0) noexcept
      : level_J_(std::clamp(level_J, 0.0, std::max(0.0, holds_J))), holds_J_(std::max(0.0, holds_J)) {}

  /// Takes at most `wanted_J`; returns what it could take.
  [[nodiscard]] double pay(double wanted_J) noexcept {
    const double paid_J = std::clamp(wanted_J, 0.0, level_J_);
    level_J_ -= paid_J;
    paid_J_ += paid_J;
    return paid_J;
  }
  void fill(double by_J) noexcept {
    const double kept_J = std::clamp(by_J, 0.0, holds_J_ - level_J_);
    level_J_ += kept_J;
    filled_J_ += std::max(0.0, by_J);
    lost_J_ += std::max(0.0, by_J) - kept_J;
  }

  [[nodiscard]] double level_J() const noexcept { return level_J_; }
  [[nodiscard]] double paid_J() const noexcept { return paid_J_; }      ///< since the beginning
  [[nodiscard]] double filled_J() const noexcept { return filled_J_; }  ///< since the beginning, the lost part included
  [[nodiscard]] double lost_J() const noexcept { return lost_J_; }

 private:
  double level_J_;
  double holds_J_;
  double paid_J_ = 0.0;
  double filled_J_ = 0.0;
  double lost_J_ = 0.0;
};

}  // namespace telepalp::tissue
