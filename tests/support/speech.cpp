#include "tests/support/speech.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::support {
namespace {

constexpr double kRate_hz = kVoiceRate_hz;

/// Loudness of the syllables, 0 to 1: four a second, and a pause in each third second.
double loudness(double at_s) {
  if (std::fmod(at_s, 3.0) > 2.5) return 0.0;
  const double syllable = std::sin(std::numbers::pi * 4.0 * at_s);
  return syllable * syllable;
}

}  // namespace

codec::VoiceSamples speech(std::uint32_t number) {
  codec::VoiceSamples samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double at_s = (static_cast<double>(number) * kVoiceFrameSamples + static_cast<double>(i)) / kRate_hz;
    // The integral of a pitch of 140 Hz that sways by 25 Hz twice a second and by 20 Hz in 7 s.
    const double turns = 140.0 * at_s + 25.0 / (4.0 * std::numbers::pi) * std::sin(4.0 * std::numbers::pi * at_s) +
                         20.0 * 7.0 / (2.0 * std::numbers::pi) * std::sin(2.0 * std::numbers::pi * at_s / 7.0);
    double sum = 0.0;
    for (int harmonic = 1; harmonic <= 12; ++harmonic)
      sum += std::sin(2.0 * std::numbers::pi * harmonic * turns) / harmonic;
    samples[i] = static_cast<float>(0.2 * loudness(at_s) * sum);
  }
  return samples;
}

double correlation(std::span<const float> a, std::span<const float> b) noexcept {
  double product = 0.0, a_energy = 0.0, b_energy = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    product += double{a[i]} * b[i];
    a_energy += double{a[i]} * a[i];
    b_energy += double{b[i]} * b[i];
  }
  const double energy = std::sqrt(a_energy * b_energy);
  return energy > 0.0 ? product / energy : 0.0;
}

Alignment aligned(std::span<const float> said, std::span<const float> heard, std::size_t most_samples) {
  Alignment best;
  for (std::size_t lag = 0; lag <= most_samples && lag < heard.size(); ++lag) {
    const std::size_t common = std::min(said.size(), heard.size() - lag);
    const double alike = correlation(said.first(common), heard.subspan(lag, common));
    if (alike > best.correlation) best = {.lag_samples = static_cast<std::ptrdiff_t>(lag), .correlation = alike};
  }
  return best;
}

}  // namespace telepalp::support
