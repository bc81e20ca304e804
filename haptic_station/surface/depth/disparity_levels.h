#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::surface {

/// Histogram of an image: number of pixels for each sample value, 0 to 65535.
using SampleCounts = std::vector<std::uint32_t>;

/// Counts the measured pixels of an image. The sample 0, "not measured", is left out.
[[nodiscard]] SampleCounts counts_of(const DepthImage& depth);

/// The depth levels of a camera that measures disparity in whole steps: 1/z grows by the same amount from level to
/// level. The camera then rounds z to whole units of the sample, so that a sample differs from its level by up to half
/// a unit, by the same amount in each frame. An average over frames or pixels does not remove this rounding error;
/// replacing each sample by its level does.
struct DisparityLevels {
  double farthest_per_unit = 0.0;  ///< 1/z of the farthest level, with z in units of the samples
  double step_per_unit = 0.0;      ///< increase of 1/z from level to level; above 0

  /// The depth that `sample` stands for [unit]: the mean of the levels within kMostMiss of it, or `sample` itself if
  /// there is no such level.
  [[nodiscard]] double depth_of(double sample) const noexcept;
  /// Distance of `sample` from the nearest level [unit].
  [[nodiscard]] double miss_of(double sample) const noexcept;
  /// Share of the pixels whose sample is within kMostMiss of a level.
  [[nodiscard]] double share_on_levels(const SampleCounts& counts) const noexcept;

  static constexpr double kMostMiss = 0.55;  ///< half a unit of rounding plus the error of the fit [unit]
};

/// Fits the levels to the samples of an image up to 3 m. Accuracy: 0.02 mm over the range of the samples, for a torso
/// at 0.8 m in samples of 1 mm. nullopt if less than 95 % of the pixels are on levels, if the levels are so dense that
/// any samples would fit, if the range is too short to tell levels in 1/z from levels in z, or if fewer than 40 sample
/// values occur. `unit_m`: metres per unit.
[[nodiscard]] std::optional<DisparityLevels> disparity_levels_of(const SampleCounts& counts, double unit_m);

}  // namespace telepalp::surface
