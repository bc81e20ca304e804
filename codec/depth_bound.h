#pragma once

#include <cstdint>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// How far Bounded may move a depth z [m]: max(least_m, per_m * z²). The default is one disparity step of a
/// Kinect-class camera, so about the sensor's own resolution, and never less than a millimetre.
struct DepthBound {
  double least_m = 0.001;
  double per_m = 2.85e-3;

  [[nodiscard]] double at(double z_m) const noexcept;
};

/// What each of the 65 536 samples is replaced by. 0 stays 0, and nothing else becomes 0.
using LevelMap = std::vector<std::uint16_t>;

/// A map onto fewer levels, each sample within its bound, in whole units; made to part as few neighbouring pixels of
/// `depth` as may be. Levels are replaced, not pixels: what was flat stays flat, and a frame that follows keeps the
/// map.
[[nodiscard]] LevelMap bounded_levels(const DepthImage& depth, const DepthBound& bound);

[[nodiscard]] DepthImage with_levels(const DepthImage& depth, const LevelMap& map);

}  // namespace telepalp::codec
