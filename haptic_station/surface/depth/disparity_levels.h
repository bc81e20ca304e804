#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::surface {

/// Number of pixels by sample, [0, 65535].
using SampleCounts = std::vector<std::uint32_t>;

/// Counts the measured pixels of an image. The sample 0, "not measured", is left out.
[[nodiscard]] SampleCounts counts_of(const DepthImage& depth);

/// The depths of a camera that measures disparity in whole steps: 1/z grows by the same amount from level to level. The
/// camera then rounds z to whole units, so that a sample is up to half a unit beside its level, always by the same
/// amount. An average over frames or pixels does not remove this error; these levels do. In 1/unit of the samples.
struct DisparityLevels {
  double farthest_per_unit = 0.0;  ///< 1/z of a level
  double step_per_unit = 0.0;      ///< from level to level; above 0

  /// The depth that `sample` stands for [unit]: the mean of the levels that round to it. `sample` itself if no level
  /// does. Never farther than kMostMiss from `sample`.
  [[nodiscard]] double depth_of(double sample) const noexcept;
  /// Distance of `sample` from the nearest level [unit].
  [[nodiscard]] double miss_of(double sample) const noexcept;
  /// Share of the pixels whose sample is a level.
  [[nodiscard]] double share_on_levels(const SampleCounts& counts) const noexcept;

  static constexpr double kMostMiss = 0.55;  ///< half a unit, and the law's own error
};

/// The levels that explain the samples of an image. Error: below 0.02 mm over the image's own range, for a torso at 0.8
/// m in samples of 1 mm. nullopt if no levels explain them, if so few values are missing between the levels that any
/// samples would fit, or if the range is too short to tell levels in 1/z from levels in z. `unit_m`: metres per unit.
[[nodiscard]] std::optional<DisparityLevels> disparity_levels_of(const SampleCounts& counts, double unit_m);

}  // namespace telepalp::surface
