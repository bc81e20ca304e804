#pragma once

#include <cstdint>
#include <vector>

#include "codec/depth.h"
#include "codec/levels/ranked_frame.h"
#include "proto/words/depth/depth_window.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// A DepthErrorBound in units of a sample: the largest allowed change of a sample.
struct BoundInUnits {
  DepthErrorBound bound;
  double unit_m = 0.001;

  [[nodiscard]] int operator()(int sample) const noexcept;
};

/// The reconstruction levels: the depths to which near-lossless coding moves the depths of a frame.
struct ReconstructionLevels {
  LevelPalette levels;
  BoundInUnits bound;
};

/// Chooses reconstruction levels: few levels, such that as many neighbouring pixels of `depth` as possible can take the
/// same one. `palette` holds the distinct depths of `depth`.
[[nodiscard]] ReconstructionLevels reconstruction_levels_for(const DepthImage& depth, const LevelPalette& palette,
                                                             const DepthErrorBound& bound);

/// The range of reconstruction levels that each pixel may take; the coder chooses one of them. If a depth has no level
/// within its bound (the levels were chosen for the key frame), the function adds one to `reconstruction`.
[[nodiscard]] RankedFrame within_bounds(const DepthImage& depth, const LevelPalette& palette,
                                        ReconstructionLevels& reconstruction);

/// As within_bounds(), with the bounds that `window` states around it. `outer`: the image, with its pixels in the
/// window set to "not measured". `palette`: of `outer`. The levels of `reconstruction` may have been chosen for another
/// frame or window.
[[nodiscard]] RankedFrame within_window(const DepthImage& outer, const LevelPalette& palette,
                                        ReconstructionLevels& reconstruction, const DepthWindow& window);

}  // namespace telepalp::codec
