#pragma once

#include <cstdint>
#include <vector>

#include "server/capture/synthetic/motion/breathing.h"

namespace telepalp::capture {

/// Parameters of a random sequence of breaths. The shares of inhale and pause are relative to one breath's duration.
struct BreathStyle {
  double amplitude_m = 0.005;     ///< mean rise of the belly above full exhale
  double rate_hz = 0.25;          ///< 1 / (mean period of a breath)
  double period_spread = 0.2;     ///< each period differs from the mean by at most this share of the mean
  double amplitude_spread = 0.3;  ///< each amplitude differs from the mean by at most this share of the mean
  double least_inhale = 0.3;      ///< the share of a period for inhaling is drawn from this to `most_inhale`
  double most_inhale = 0.45;
  double most_pause = 0.15;  ///< the share of a period for the pause after exhaling is drawn from 0 to this
  double ripple_m = 0.0;     ///< amplitude of an oscillation at 3 to 5 Hz (one cycle a syllable) while exhaling
};

/// A random sequence of breaths. Drawn for each breath: period, amplitude, lift (the belly's height above full exhale)
/// at its end, shares of inhale and pause, and skew of the exhale. The sequence has 256 breaths and repeats, so the
/// lift is a pure function of time; this function is continuously differentiable.
class BreathSequence {
 public:
  BreathSequence(const BreathStyle& style, std::uint64_t seed);

  /// The belly's motion `time_s` seconds after the sequence's beginning, for any finite time. `speed`: increase of
  /// `time_s` per second of real time, 0 while the breath is held.
  [[nodiscard]] Breath at(double time_s, double speed = 1.0) const noexcept;
  [[nodiscard]] double duration_s() const noexcept { return ends_s_.empty() ? 0.0 : ends_s_.back(); }

 private:
  struct Drawn {
    double begins_s;
    double period_s;
    double from_m;
    double peak_m;
    double to_m;
    double inhale;  ///< share of `period_s`
    double pause;   ///< share of `period_s`
    double skew;    ///< exponent on the exhale's time: below 1, the exhale begins fast
    double syllables_hz;
  };
  [[nodiscard]] Breath within(const Drawn& breath, double from_begin_s) const noexcept;

  double ripple_m_ = 0.0;
  std::vector<Drawn> breaths_;
  std::vector<double> ends_s_;
};

}  // namespace telepalp::capture
