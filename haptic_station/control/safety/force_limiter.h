#pragma once

#include <limits>

#include "haptic_station/ports/readings.h"
#include "proto/words/frames.h"
#include "proto/words/last_result.h"
#include "proto/words/wrench.h"

namespace telepalp::control {

/// Limits of the force, for the device and for the hand.
struct ForceLimits {
  double peak_N = 10.0;          ///< never exceeded (paper S1 II.A, docs/sources.md)
  double continuous_N = 4.0;     ///< may be held without time limit (S1 II.A)
  double thermal_time_s = 20.0;  ///< time constant of the motors' heating
  double slew_N_per_s = 2000.0;  ///< largest rate of change; a low value delays the force, which adds energy
};

/// Every wrench to the device passes this limiter, which bounds its peak, the motors' heat and its rate of change. A
/// wrench that is not finite latches a fault: until rearm(), each wrench counts as zero. The torque has a budget of its
/// own, the greatest torque of the device, which falls with the heat in proportion to the force's bound. Owner: haptic
/// thread.
class ForceLimiter {
 public:
  explicit ForceLimiter(const ForceLimits& limits = {}) noexcept : limits_(limits) {}

  /// The greatest force and torque that the device states. A torque of 0: the device gets none.
  void device_gives(const ports::DevicePower& power) noexcept;

  /// Returns `wanted` after the limits, `dt_s` after the last call. The heat is the squared force, low-pass filtered
  /// with the time constant thermal_time_s; a torque heats like the same share of the greatest force. As the heat rises
  /// from 40 % to 100 % of continuous_N², the largest force falls from peak_N to continuous_N.
  [[nodiscard]] Wrench<HapticBase> limit(const Wrench<HapticBase>& wanted, double dt_s) noexcept;

  [[nodiscard]] bool limited() const noexcept { return limited_; }
  [[nodiscard]] bool faulted() const noexcept { return faulted_; }
  [[nodiscard]] double heat_N2() const noexcept { return heat_N2_; }
  [[nodiscard]] double bound_N() const noexcept;  ///< the largest force that the heat and the device allow now
  /// Greatest torque of the device, per newton of its greatest force [m]; 0: no torque.
  [[nodiscard]] double lever_m() const noexcept { return lever_m_; }
  /// Time until the heat lowers the bound below `force_N`, if that force is held [s]; infinite: never.
  [[nodiscard]] double holds_for_s(double force_N) const noexcept;
  void rearm() noexcept { faulted_ = false; }

 private:
  [[nodiscard]] double heat_bound_N() const noexcept;
  [[nodiscard]] Torque<HapticBase> limit_torque(const Torque<HapticBase>& wanted, double dt_s) noexcept;

  ForceLimits limits_;
  Wrench<HapticBase> given_;
  double device_N_ = std::numeric_limits<double>::infinity();
  double lever_m_ = 0.0;
  double heat_N2_ = 0.0;
  LastExp heat_left_;  ///< share of the heat that is left after a tick
  bool limited_ = false;
  bool faulted_ = false;
};

}  // namespace telepalp::control
