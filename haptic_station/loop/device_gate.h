#pragma once

#include <cstdint>

#include "haptic_station/ports/readings.h"
#include "proto/words/last_result.h"

namespace telepalp::loop {

/// A reading of the end-effector after the gate.
struct GatedReading {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double implausible_s = 0.0;   ///< how long the readings have been impossibly fast; 0: this one is plausible
  double unreadable_s = 0.0;    ///< how long the readings have not been finite; 0: this one is finite
};

/// Bridges encoder jumps that are impossibly fast. While a reading is farther from the expected position than a hand
/// can move, the position is extrapolated with the last velocity, which decays. A small lasting offset is removed
/// slowly. While an offset is large, readings count as implausible, so that the controller faults; once they have been
/// consistent for half a second, they are accepted unchanged. A reading with a number that is not finite is bridged
/// in the same way. The position returned is always finite. Owner: haptic thread.
class DeviceGate {
 public:
  [[nodiscard]] GatedReading step(const ports::DeviceReading& reading, double dt_s) noexcept;

  /// Number of implausible jumps since start.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return jumps_; }

 private:
  [[nodiscard]] GatedReading bridge(double dt_s) noexcept;
  void come_back(const ports::DeviceReading& reading, double since_s, double dt_s) noexcept;
  void go_on(double dt_s) noexcept;
  void start(const ports::DeviceReading& reading) noexcept;
  void accept(const ports::DeviceReading& reading, double since_s, double dt_s) noexcept;
  void hold(const ports::DeviceReading& reading, double dt_s) noexcept;
  [[nodiscard]] double allowed_m(double speed_m_per_s, double since_s) const noexcept;
  [[nodiscard]] GatedReading answer(const ports::DeviceReading& reading) const noexcept;

  bool started_ = false;
  ports::DeviceReading last_;                            ///< the last reading
  Eigen::Vector3d at_m_ = Eigen::Vector3d::Zero();       ///< position returned last
  Eigen::Vector3d speed_ = Eigen::Vector3d::Zero();      ///< velocity of `at_m_` [m/s], low-pass filtered
  Eigen::Vector3d raw_speed_ = Eigen::Vector3d::Zero();  ///< velocity from the last two readings [m/s]
  Eigen::Vector3d offset_m_ = Eigen::Vector3d::Zero();   ///< returned minus read position, while a slip is removed
  LastExp speed_left_;                                   ///< weight of the older readings in `speed_` after a reading
  double implausible_s_ = 0.0;
  double unreadable_s_ = 0.0;
  double agree_s_ = 0.0;  ///< how long consecutive readings have been consistent with each other
  std::uint64_t jumps_ = 0;
};

}  // namespace telepalp::loop
