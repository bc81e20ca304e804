#pragma once

#include <cstdint>
#include <vector>

#include "server/capture/synthetic/motion/breathing.h"

namespace telepalp::server {

/// How much breaths differ, and what they look like. Shares are of one breath's time.
struct BreathStyle {
  double amplitude_m = 0.005;
  double rate_hz = 0.25;
  double period_spread = 0.2;     ///< each period is within this share of the mean
  double amplitude_spread = 0.3;  ///< and each amplitude
  double least_inhale = 0.3;      ///< share of the breath spent inhaling, drawn for each breath
  double most_inhale = 0.45;
  double most_pause = 0.15;  ///< share spent at rest after exhaling, drawn from 0
  double ripple_m = 0.0;     ///< of the syllables of a patient who speaks while exhaling
};

/// Breaths that are drawn one by one: period, amplitude, the level that the exhale ends at, the shares of inhale and
/// pause, and how the exhale is skewed. A sequence of 256 breaths that repeats, so that every instant is a pure
/// function of time. Continuous with its rate.
class BreathSequence {
 public:
  BreathSequence(const BreathStyle& style, std::uint64_t seed);

  /// `time_s` from the sequence's beginning, any; `speed`: of that time itself, 0 while the breath is held.
  [[nodiscard]] Breath at(double time_s, double speed = 1.0) const noexcept;
  [[nodiscard]] double duration_s() const noexcept { return ends_s_.empty() ? 0.0 : ends_s_.back(); }

 private:
  struct Drawn {
    double begins_s;
    double period_s;
    double from_m;
    double peak_m;
    double to_m;
    double inhale;  ///< share
    double pause;   ///< share
    double skew;    ///< exponent on the exhale's time: below 1, the exhale begins fast
    double syllables_hz;
  };
  [[nodiscard]] Breath within(const Drawn& breath, double from_begin_s) const noexcept;

  double ripple_m_ = 0.0;
  std::vector<Drawn> breaths_;
  std::vector<double> ends_s_;
};

}  // namespace telepalp::server
