#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codec/bounded/reconstruction.h"
#include "codec/depth.h"
#include "proto/words/depth/depth_window.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// Depth images of one camera, with the limits for presses.
struct DepthSequence {
  std::string name;
  Intrinsics camera;
  std::vector<DepthImage> frames;
  double farthest_m = 1.0;  ///< places farther from the camera are not pressed
};

/// The recorded room in the repository, and the synthetic torso through a Kinect-like sensor.
[[nodiscard]] Result<std::vector<DepthSequence>> depth_sequences();

/// Size and time of a mode on a sequence, and the force error at a finger.
struct DepthPrice {
  double bits_per_pixel = 0.0;
  double ratio = 0.0;  ///< compression ratio to 16-bit samples
  double worst_mm = 0.0;
  double rms_mm = 0.0;
  double encode_p50_ms = 0.0;  ///< processor time
  double decode_p50_ms = 0.0;
  // RMS force error at 500 N/m, 5 mm below the surface, relative to the force on the captured samples
  double force_rms_N = 0.0;
  double force_p99_N = 0.0;
  double force_max_N = 0.0;
  int places = 0;
};

/// Measures `mode`. `bound`: the error bound of DepthMode::Bounded. With a window, as in the station, the surface is
/// built from its exact depth alone, so places outside are not pressed; the depth error is that of the whole image.
[[nodiscard]] Result<DepthPrice> price_of(const DepthSequence& sequence, codec::DepthMode mode,
                                          const DepthErrorBound& bound,
                                          const std::optional<DepthWindow>& window = std::nullopt);

/// A rectangle of `share` of the image's pixels around the middle of what may be pressed in `sequence`.
[[nodiscard]] PixelRect rect_of_the_hand(const DepthSequence& sequence, double share);

}  // namespace telepalp::bench
