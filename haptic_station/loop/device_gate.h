#pragma once

#include <cstdint>

#include "haptic_station/ports/readings.h"

namespace telepalp::loop {

/// Bounds of the end-effector's motion in a hand, and the handling of readings outside them.
struct DeviceGateSettings {
  double most_acceleration_m_per_s2 = 300.0;
  double encoder_noise_m = 0.05e-3;
  double timing_error = 0.5;  ///< relative error of the time between two readings
  double slip_m = 0.005;      ///< a lasting offset up to this is removed slowly; a larger one counts as implausible
  double believed_after_s = 0.001;  ///< readings that agree for this long after a jump show a lasting offset (slip)
  double rebased_after_s = 0.5;  ///< after a large offset, readings that agree for this long are accepted as they are
  double absorbed_over_s = 0.02;
  double absorbed_m_per_s = 0.15;  ///< fastest removal of an offset: 0.04 N a tick on a skin of 500 N/m
};

/// A reading as the controller may use it.
struct GatedReading {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double implausible_s = 0.0;   ///< for how long readings have been impossibly fast; 0: this one is plausible
};

/// Bridges encoder jumps that are impossibly fast: while a reading cannot follow from the one before, the end-effector
/// is extrapolated with its last velocity. A short glitch is bridged. A small lasting slip is removed slowly. A large
/// lasting offset stays implausible, and the controller then faults. Owner: haptic thread.
class DeviceGate {
 public:
  explicit DeviceGate(const DeviceGateSettings& settings = {}) noexcept : settings_(settings) {}

  [[nodiscard]] GatedReading step(const ports::DeviceReading& reading, double dt_s) noexcept;

  /// Number of implausible jumps since start.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return jumps_; }

 private:
  void start(const ports::DeviceReading& reading) noexcept;
  void accept(const ports::DeviceReading& reading, double since_s, double dt_s) noexcept;
  void hold(const ports::DeviceReading& reading, double dt_s) noexcept;
  [[nodiscard]] double allowed_m(double speed_m_per_s, double since_s) const noexcept;
  [[nodiscard]] GatedReading answer(const ports::DeviceReading& reading) const noexcept;

  DeviceGateSettings settings_;
  bool started_ = false;
  ports::DeviceReading last_;                            ///< the last reading
  Eigen::Vector3d at_m_ = Eigen::Vector3d::Zero();       ///< the position returned last
  Eigen::Vector3d speed_ = Eigen::Vector3d::Zero();      ///< velocity of `at_m_` [m/s], low-pass filtered
  Eigen::Vector3d raw_speed_ = Eigen::Vector3d::Zero();  ///< velocity from the last two readings [m/s]
  Eigen::Vector3d offset_m_ = Eigen::Vector3d::Zero();   ///< returned minus read position: a slip that is being removed
  double implausible_s_ = 0.0;
  double agree_s_ = 0.0;  ///< for how long readings have agreed with each other
  std::uint64_t jumps_ = 0;
};

}  // namespace telepalp::loop
