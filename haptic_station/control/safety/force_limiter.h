#pragma once

#include "proto/words/frames.h"

namespace telepalp::control {

/// What the device and the hand can take.
struct ForceLimits {
  double peak_N = 10.0;          ///< never exceeded (S1 II.A)
  double continuous_N = 4.0;     ///< may be held for ever (S1 II.A)
  double thermal_time_s = 20.0;  ///< time constant of the motors' heating
  double slew_N_per_s = 2000.0;  ///< largest change of the force; a lag, so slower than stiff contact it adds energy
};

/// The one way to the device: bounds peak, heat and change of the force. A force that is not finite counts as
/// zero, and latches a fault until rearm(). Owner: control thread.
class ForceLimiter {
 public:
  explicit ForceLimiter(const ForceLimits& limits = {}) noexcept : limits_(limits) {}

  /// The force to give for the force `wanted`, `dt_s` after the last one. Heat is the mean square force over
  /// thermal_time_s; the bound falls slowly from peak to continuous as the heat nears that of the continuous force.
  [[nodiscard]] Force<HapticBase> limit(const Force<HapticBase>& wanted, double dt_s) noexcept;

  [[nodiscard]] bool limited() const noexcept { return limited_; }
  [[nodiscard]] bool faulted() const noexcept { return faulted_; }
  [[nodiscard]] double heat_N2() const noexcept { return heat_N2_; }
  [[nodiscard]] double bound_N() const noexcept;
  /// Time until the heat lowers the bound below `force_N`, if that force is held [s]; infinite when it never does.
  [[nodiscard]] double holds_for_s(double force_N) const noexcept;
  void rearm() noexcept { faulted_ = false; }

 private:
  ForceLimits limits_;
  Force<HapticBase> given_;
  double heat_N2_ = 0.0;
  bool limited_ = false;
  bool faulted_ = false;
};

}  // namespace telepalp::control
