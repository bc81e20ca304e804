#include "server/capture/synthetic/motion/breath_sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/capture/synthetic/motion/quintic_step.h"
#include "server/capture/synthetic/motion/seeded_draw.h"

namespace telepalp::capture {
namespace {

constexpr int kBreaths = 256;
constexpr double kRestSpread = 0.1;  // spread of the end level between breaths, as a share of the amplitude

}  // namespace

BreathSequence::BreathSequence(const BreathStyle& style, std::uint64_t seed) : ripple_m_(style.ripple_m) {
  if (!(style.rate_hz > 0.0) || !(style.amplitude_m > 0.0)) return;
  const auto rest_m = [&](int i) {
    return style.amplitude_m * seeded_draw(seed, i % kBreaths, 0, 0.0, 2.0 * kRestSpread);
  };
  double begins_s = 0.0;
  for (int i = 0; i < kBreaths; ++i) {
    const auto draw = [&](std::uint64_t which, double least, double most) {
      return seeded_draw(seed, i, which, least, most);
    };
    const double period_s = (1.0 + draw(1, -style.period_spread, style.period_spread)) / style.rate_hz;
    breaths_.push_back({.begins_s = begins_s,
                        .period_s = period_s,
                        .from_m = rest_m(i),
                        .peak_m = style.amplitude_m * (1.0 + draw(2, -style.amplitude_spread, style.amplitude_spread)),
                        .to_m = rest_m(i + 1),
                        .inhale = draw(3, style.least_inhale, style.most_inhale),
                        .pause = draw(4, 0.0, style.most_pause),
                        .skew = draw(5, 0.6, 0.9),
                        .syllables_hz = draw(6, 3.0, 5.0)});
    ends_s_.push_back(begins_s += period_s);
  }
}

Breath BreathSequence::within(const Drawn& breath, double from_begin_s) const noexcept {
  const double phase = from_begin_s / breath.period_s;
  if (phase < breath.inhale) {
    const Changing up = quintic_step(phase / breath.inhale);
    return {.lift_m = breath.from_m + (breath.peak_m - breath.from_m) * up.value,
            .speed_m_per_s = (breath.peak_m - breath.from_m) * up.rate / (breath.inhale * breath.period_s)};
  }
  const double exhale = 1.0 - breath.inhale - breath.pause;
  const double x = std::min(1.0, (phase - breath.inhale) / exhale);
  const double skewed = std::pow(x, breath.skew);
  const Changing down = quintic_step(skewed);
  const double skew_rate = x > 0.0 && x < 1.0 ? breath.skew * skewed / x : 0.0;
  const double syllable = 2.0 * std::numbers::pi * breath.syllables_hz;
  const double window = std::sin(std::numbers::pi * x);
  const double window_rate = 2.0 * window * std::cos(std::numbers::pi * x) * std::numbers::pi;
  const double wave = std::sin(syllable * from_begin_s);
  const double exhale_s = exhale * breath.period_s;
  return {.lift_m = breath.peak_m + (breath.to_m - breath.peak_m) * down.value + ripple_m_ * window * window * wave,
          .speed_m_per_s = (breath.to_m - breath.peak_m) * down.rate * skew_rate / exhale_s +
                           ripple_m_ * (x < 1.0 ? window_rate * wave / exhale_s : 0.0) +
                           ripple_m_ * window * window * syllable * std::cos(syllable * from_begin_s)};
}

Breath BreathSequence::at(double time_s, double speed) const noexcept {
  if (breaths_.empty()) return {};
  const double turns = std::floor(time_s / duration_s());
  const double at_s = std::clamp(time_s - turns * duration_s(), 0.0, duration_s());
  const auto end = std::upper_bound(ends_s_.begin(), ends_s_.end() - 1, at_s);
  const Drawn& breath = breaths_[static_cast<std::size_t>(end - ends_s_.begin())];
  Breath now = within(breath, at_s - breath.begins_s);
  now.speed_m_per_s *= speed;
  return now;
}

}  // namespace telepalp::capture
