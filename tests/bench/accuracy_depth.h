#pragma once

#include <string>
#include <vector>

#include "codec/bounded/reconstruction.h"
#include "codec/depth.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// Depth images of one camera, and where a finger goes.
struct DepthSequence {
  std::string name;
  Intrinsics camera;
  std::vector<DepthImage> frames;
  double farthest_m = 1.0;  ///< places farther from the camera are not pressed
};

/// The recorded room that ships, and the synthetic torso as a Kinect sees it.
[[nodiscard]] Result<std::vector<DepthSequence>> depth_sequences();

/// What a mode makes of a sequence, and what a finger feels of it.
struct DepthPrice {
  double bits_per_pixel = 0.0;
  double ratio = 0.0;  ///< to 16-bit samples
  double worst_mm = 0.0;
  double rms_mm = 0.0;
  double encode_p50_ms = 0.0;  ///< processor time
  double decode_p50_ms = 0.0;
  // at 500 N/m, 5 mm under the surface, against what the same finger feels of the samples as they were captured
  double force_rms_N = 0.0;
  double force_p99_N = 0.0;
  double force_max_N = 0.0;
  int places = 0;
};

/// What `mode` costs. `bound`: of Bounded.
[[nodiscard]] Result<DepthPrice> price_of(const DepthSequence& sequence, codec::DepthMode mode,
                                          const DepthErrorBound& bound);

}  // namespace telepalp::bench
