#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/voice.h"

namespace telepalp::support {

/// Frame `number` of a sound like speech: syllables of a voice whose pitch rises and falls, with pauses. No two parts
/// of ten seconds are alike, so that sound which was shifted or left out is found.
[[nodiscard]] codec::VoiceSamples speech(std::uint32_t number);

/// Cosine of the angle between two sounds of one length; 0 if one of them is silence.
[[nodiscard]] double correlation(std::span<const float> a, std::span<const float> b) noexcept;

struct Alignment {
  std::ptrdiff_t lag_samples = 0;  ///< by which `heard` lags behind `said`
  double correlation = 0.0;
};
/// The lag, from 0 to `most_samples`, at which `heard` is most alike `said`.
[[nodiscard]] Alignment aligned(std::span<const float> said, std::span<const float> heard, std::size_t most_samples);

}  // namespace telepalp::support
