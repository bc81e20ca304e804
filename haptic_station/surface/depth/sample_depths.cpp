#include "haptic_station/surface/depth/sample_depths.h"

#include <algorithm>

namespace telepalp::surface {
namespace {

constexpr int kFirstImages = 8;             // each is checked until one shows levels
constexpr int kCheckEvery = 32;             // period of the checks [images]
constexpr double kStillOnLevels = 0.9;      // share of the pixels; software may have changed the others
constexpr std::uint64_t kFewPixels = 1000;  // an image with fewer measured pixels is not checked

}  // namespace

DepthField SampleDepths::field_of(const DepthImage& depth) {
  DepthField field;
  field_of(depth, field);
  return field;
}

void SampleDepths::field_of(const DepthImage& depth, DepthField& field) {
  if (depth.unit_m != unit_m_) {
    use(std::nullopt);
    unit_m_ = depth.unit_m;
    images_ = 0;
  }
  if (images_ % kCheckEvery == 0 || (!levels_ && images_ < kFirstImages)) check(depth);
  ++images_;
  if (!levels_) return to_depth_field(depth, field);
  field.width = depth.width;
  field.height = depth.height;
  field.z_m.resize(depth.samples.size());
  std::transform(depth.samples.begin(), depth.samples.end(), field.z_m.begin(),
                 [by_sample = depth_m_.data()](std::uint16_t sample) { return by_sample[sample]; });
}

/// Known levels are kept as long as they explain the images. A new fit would move all depths by a few micrometres.
void SampleDepths::check(const DepthImage& depth) {
  const SampleCounts counts = counts_of(depth);
  std::uint64_t measured = 0;
  for (const std::uint32_t count : counts) measured += count;
  if (measured < kFewPixels) return;
  if (levels_ && levels_->share_on_levels(counts) >= kStillOnLevels) return;
  use(disparity_levels_of(counts, unit_m_));
}

void SampleDepths::use(const std::optional<DisparityLevels>& levels) {
  levels_ = levels;
  depth_m_.clear();
  if (!levels_) return;
  depth_m_.resize(65536, 0.0F);
  for (std::size_t sample = 1; sample < depth_m_.size(); ++sample)
    depth_m_[sample] = static_cast<float>(unit_m_ * levels_->depth_of(static_cast<double>(sample)));
}

}  // namespace telepalp::surface
