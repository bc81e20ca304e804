#include "server/pipeline/encode_options.h"

#include <algorithm>

namespace telepalp::pipeline {
namespace {

/// About 0.6 and 0.35 of the bytes at the default of 85.
constexpr int kSmallerColour = 60;
constexpr int kSmallestColour = 25;

/// The rate of colour as video at a level above 0: 60 % of `kbit_per_s` at level 1, 35 % from level 2 on.
int shrunk_rate(int kbit_per_s, std::size_t level) { return std::max(1, kbit_per_s * (level == 1 ? 60 : 35) / 100); }

}  // namespace

EncodeOptions shrunk(EncodeOptions asked, std::size_t level) noexcept {
  if (level == 0) return asked;
  if (asked.depth.mode == codec::DepthMode::Fast) asked.depth.mode = codec::DepthMode::Intra;
  asked.jpeg_quality = std::min(asked.jpeg_quality, level == 1 ? kSmallerColour : kSmallestColour);
  asked.video_kbit_per_s = shrunk_rate(asked.video_kbit_per_s, level);
  if (level == 1) return asked;
  asked.depth.bound.least_m *= 2.0;
  asked.depth.bound.per_m *= 2.0;
  return asked;
}

EncodeOptions with(EncodeOptions asked, const plan::ImageSettings& settings) noexcept {
  EncodeOptions options = shrunk(asked, settings.level);
  options.jpeg_quality = std::min(options.jpeg_quality, settings.jpeg_quality);
  options.video_kbit_per_s = std::min(options.video_kbit_per_s, settings.video_kbit_per_s);
  if (settings.whole_factor <= 0.0) return options;
  const bool is_bounded = asked.depth.mode == codec::DepthMode::Bounded;
  const DepthErrorBound least = is_bounded ? asked.depth.bound : codec::kOneDisparityStep;
  options.depth.mode = codec::DepthMode::Bounded;
  options.depth.bound = {.least_m = settings.whole_factor * least.least_m,
                         .per_m = settings.whole_factor * least.per_m};
  return options;
}

}  // namespace telepalp::pipeline
