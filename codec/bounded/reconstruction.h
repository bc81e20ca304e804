#pragma once

#include <cstdint>
#include <vector>

#include "codec/depth.h"
#include "codec/levels/ranked_frame.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// DepthErrorBound in sample units: the largest allowed change of a sample.
struct BoundInUnits {
  DepthErrorBound bound;
  double unit_m = 0.001;

  [[nodiscard]] int operator()(int sample) const noexcept;
};

/// The few levels that the many levels of a frame are quantised to.
struct ReconstructionLevels {
  LevelPalette levels;
  BoundInUnits bound;
};

/// Chooses reconstruction levels that are few, and that as many neighbouring pixels of `depth` as possible can share.
/// `palette` holds the levels of `depth`.
[[nodiscard]] ReconstructionLevels reconstruction_levels_for(const DepthImage& depth, const LevelPalette& palette,
                                                             const DepthErrorBound& bound);

/// The range of reconstruction levels that each pixel may take; the coder chooses within it. A depth without a level
/// within its bound, because the key frame did not have that depth, adds a level to `reconstruction`.
[[nodiscard]] RankedFrame within_bounds(const DepthImage& depth, const LevelPalette& palette,
                                        ReconstructionLevels& reconstruction);

}  // namespace telepalp::codec
