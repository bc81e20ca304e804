#pragma once

#include <optional>

#include "haptic_station/device/random.h"
#include "proto/words/frames.h"

namespace telepalp::device {

struct SimulatedTrackerSettings {
  double rate_hz = 100.0;
  double noise_m = 0.0002;  ///< standard deviation per axis
  double jitter_s = 0.001;  ///< largest delay of a sample, uniformly distributed
};

/// Simulates a hand tracker that observes the simulated hand: jittered samples with noise. Pure and seeded.
class SimulatedTracker {
 public:
  SimulatedTracker(const SimulatedTrackerSettings& settings, std::uint64_t seed) noexcept
      : settings_(settings), random_(seed) {}

  /// Returns a noisy sample of `hand` when one is due at `now_s`. Call it once per tick.
  [[nodiscard]] std::optional<Point<HapticBase>> sample(double now_s, const Point<HapticBase>& hand) noexcept {
    if (now_s < next_s_) return std::nullopt;
    const double period_s = 1.0 / settings_.rate_hz;
    due_s_ = now_s - due_s_ > 2.0 * period_s ? now_s : due_s_ + period_s;
    next_s_ = due_s_ + random_.uniform(0.0, settings_.jitter_s);
    return Point<HapticBase>{hand.m +
                             settings_.noise_m * Eigen::Vector3d{random_.normal(), random_.normal(), random_.normal()}};
  }

 private:
  SimulatedTrackerSettings settings_;
  Random random_;
  double due_s_ = 0.0;
  double next_s_ = 0.0;
};

}  // namespace telepalp::device
