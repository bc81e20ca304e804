#include "support/speech/loud_spans.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proto/words/numbers/quantile.h"

namespace telepalp::speech {
namespace {

constexpr double kQuietest_dB = -100.0;
constexpr double kLeast_dB = -50.0;        // of speech
constexpr double kAboveNoise_dB = 10.0;    // of speech
constexpr double kNoiseRise_dB = 0.02;     // in a frame: 1 dB in a second
constexpr double kLowestNoise_dB = -70.0;  // lower only where a microphone is off, or suppresses noise
constexpr Nanoseconds kPause = std::chrono::milliseconds(500);  // longest within a span
constexpr Nanoseconds kShortest = std::chrono::milliseconds(60);

bool is_long(const Spoken& span) noexcept { return span.until - span.from >= kShortest; }

}  // namespace

double level_dB(const codec::VoiceSamples& samples) noexcept {
  double energy = 0.0;
  for (const float sample : samples) energy += double{sample} * sample;
  const double of_full_sine = 2.0 * energy / static_cast<double>(samples.size());
  return std::clamp(10.0 * std::log10(std::max(of_full_sine, 1e-12)), kQuietest_dB, 0.0);
}

void LoudSpans::add(SessionTime at, double frame_dB) {
  const SessionTime until = at + kVoiceFrameTime;
  if (until <= end_) return;
  const SessionTime from = std::max(at, end_);
  end_ = until;
  noise_dB_ = std::max(std::min(frame_dB, noise_dB_ + kNoiseRise_dB), kLowestNoise_dB);
  if (frame_dB < std::max(kLeast_dB, noise_dB_ + kAboveNoise_dB)) return;
  const int loud_dB = static_cast<int>(std::lround(frame_dB));
  if (!spans_.empty() && from - spans_.back().until <= kPause) {
    spans_.back().until = until;
    spans_.back().loudest_dB = std::max(spans_.back().loudest_dB, loud_dB);
    return;
  }
  if (!spans_.empty() && !is_long(spans_.back())) spans_.pop_back();
  spans_.push_back({.from = from, .until = until, .loudest_dB = loud_dB});
  if (spans_.size() > kMost) join_closest();
}

/// Joins the half of the spans that lie closest together.
void LoudSpans::join_closest() {
  std::vector<Nanoseconds> pauses;
  for (std::size_t i = 1; i < spans_.size(); ++i) pauses.push_back(spans_[i].from - spans_[i - 1].until);
  const Nanoseconds longest = median_of(pauses);
  std::size_t left = spans_.size() / 2;
  std::vector<Spoken> joined;
  for (const Spoken& span : spans_) {
    if (joined.empty() || left == 0 || span.from - joined.back().until > longest) {
      joined.push_back(span);
      continue;
    }
    --left;
    joined.back().until = span.until;
    joined.back().loudest_dB = std::max(joined.back().loudest_dB, span.loudest_dB);
  }
  spans_ = std::move(joined);
}

std::vector<Spoken> LoudSpans::spans() const {
  std::vector<Spoken> all = spans_;
  std::erase_if(all, [](const Spoken& span) { return !is_long(span); });
  return all;
}

}  // namespace telepalp::speech
