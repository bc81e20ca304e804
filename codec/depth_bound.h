#pragma once

#include <cstdint>
#include <vector>

#include "codec/ranked_frame.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// How far Bounded may move a depth z [m]: max(least_m, per_m * z²). The default is one disparity step of a
/// Kinect-class camera, so about the sensor's own resolution, and never less than a millimetre.
struct DepthBound {
  double least_m = 0.001;
  double per_m = 2.85e-3;

  [[nodiscard]] double at(double z_m) const noexcept;
};

/// The same for samples, in whole units.
struct BoundInUnits {
  DepthBound bound;
  double unit_m = 0.001;

  [[nodiscard]] int operator()(int sample) const noexcept;
};

/// Levels that stand in for others, a few for many.
struct StandIns {
  LevelPalette levels;
  BoundInUnits bound;
};

/// Stand-ins as few, and common to as many neighbouring pixels of `depth`, as may be. `palette` is its own, as below.
[[nodiscard]] StandIns stand_ins_for(const DepthImage& depth, const LevelPalette& palette, const DepthBound& bound);

/// What each pixel of a frame may become: which one is the coder's choice. Depths that have no stand-in yet, as the
/// frame that they were made for did not have them, get one.
[[nodiscard]] RankedFrame within_bounds(const DepthImage& depth, const LevelPalette& palette, StandIns& stand_ins);

}  // namespace telepalp::codec
