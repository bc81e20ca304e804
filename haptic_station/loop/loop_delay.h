#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "haptic_station/ports/readings.h"

namespace telepalp::loop {

/// The delay of the device's loop: the age of the reading that a tick uses plus the age of the newest command that the
/// device had received before it (DeviceReading::loop_s). It contains the time that the device held this command before
/// it read its encoders, so it can be too large by this holding time, but not by more.
///
/// p99_s() is the 99th percentile of the last 1 to 2 s. Ticks at which the device has been silent for 5 ms do not
/// count: silence is for the watchdog. Owner: haptic thread.
class LoopDelay {
 public:
  void add(const ports::DeviceReading& reading) noexcept;
  /// [s]; renewed 20 times a second. nullopt: the device echoes no commands, or fewer than 100 readings came.
  [[nodiscard]] std::optional<double> p99_s() const noexcept { return p99_s_; }

 private:
  static constexpr double kBin_s = 50e-6;
  static constexpr std::size_t kBins = 400;  ///< the last bin also holds all longer delays
  /// The delays of 2000 readings (one second), in bins of kBin_s.
  struct Second {
    std::array<std::uint16_t, kBins> count{};
    std::array<float, kBins> longest_s{};  ///< longest delay in each bin
    std::uint16_t all = 0;
  };
  [[nodiscard]] double quantile_s() const noexcept;

  Second now_;
  Second before_;
  std::optional<double> p99_s_;
};

}  // namespace telepalp::loop
