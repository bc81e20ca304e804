#pragma once

#include <cstdint>

#include "haptic_station/ports/readings.h"

namespace telepalp::station {

/// What a device's end-effector can do in a hand, and how far its encoders are believed beyond that.
struct DeviceGateSettings {
  double most_acceleration_m_per_s2 = 300.0;
  double encoder_noise_m = 0.05e-3;
  double timing_error = 0.5;        ///< of the time between two readings, as a share of it
  double slip_m = 0.005;            ///< a lasting offset up to this is absorbed slowly; a larger one is not believed
  double believed_after_s = 0.001;  ///< readings that agree with each other for so long are a slip, not a glitch
  double rebased_after_s = 0.5;     ///< after a large offset, readings that agree for so long are the new truth
  double absorbed_over_s = 0.02;
  double absorbed_m_per_s = 0.15;  ///< at most: 0.04 N a tick on a skin of 500 N/m
};

/// A reading as the controller may use it.
struct GatedReading {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double implausible_s = 0.0;   ///< readings have been beyond physics for so long; 0: this one is plausible
};

/// Holds encoder jumps beyond physics: while a reading cannot follow from the one before, the end-effector is carried
/// on with its last velocity. A short glitch is bridged, a small lasting slip is absorbed slowly, a large one stays
/// implausible, which the controller makes a fault. Owner: haptic thread.
class DeviceGate {
 public:
  explicit DeviceGate(const DeviceGateSettings& settings = {}) noexcept : settings_(settings) {}

  [[nodiscard]] GatedReading step(const ports::DeviceReading& reading, double dt_s) noexcept;

  /// Readings that began to be implausible, since start.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return jumps_; }

 private:
  void start(const ports::DeviceReading& reading) noexcept;
  void accept(const ports::DeviceReading& reading, double since_s, double dt_s) noexcept;
  void hold(const ports::DeviceReading& reading, double dt_s) noexcept;
  [[nodiscard]] double allowed_m(double speed_m_per_s, double since_s) const noexcept;
  [[nodiscard]] GatedReading answer(const ports::DeviceReading& reading) const noexcept;

  DeviceGateSettings settings_;
  bool started_ = false;
  ports::DeviceReading last_;                            ///< as read
  Eigen::Vector3d at_m_ = Eigen::Vector3d::Zero();       ///< as answered
  Eigen::Vector3d speed_ = Eigen::Vector3d::Zero();      ///< of `at_m_` [m/s], low-pass
  Eigen::Vector3d raw_speed_ = Eigen::Vector3d::Zero();  ///< of the readings, from the last two [m/s]
  Eigen::Vector3d offset_m_ = Eigen::Vector3d::Zero();   ///< answered less read: a slip that is being absorbed
  double implausible_s_ = 0.0;
  double agree_s_ = 0.0;  ///< readings have agreed with each other for so long
  std::uint64_t jumps_ = 0;
};

}  // namespace telepalp::station
