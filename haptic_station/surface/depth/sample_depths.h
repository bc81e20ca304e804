#pragma once

#include <optional>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/depth/disparity_levels.h"

namespace telepalp::surface {

/// Converts the samples of depth images (16-bit integers) to metres. If an image's sample values show that the camera
/// measures disparity in whole steps, each sample gives the exact depth of its step; otherwise its rounded depth is
/// used. The first 8 images, until one shows steps, and every 32nd image are checked. Owner: surface thread.
class SampleDepths {
 public:
  /// The depths [m] of `depth`, the next image of the camera's stream; 0: not measured.
  [[nodiscard]] DepthField field_of(const DepthImage& depth);
  /// As above, but writes to `field` and reuses its memory.
  void field_of(const DepthImage& depth, DepthField& field);

  /// The depth levels of the camera's disparity steps; nullopt: the images have not shown any.
  [[nodiscard]] const std::optional<DisparityLevels>& levels() const noexcept { return levels_; }

 private:
  void check(const DepthImage& depth);
  void use(const std::optional<DisparityLevels>& levels);

  std::optional<DisparityLevels> levels_;
  std::vector<float> depth_m_;  ///< depth of each sample value; empty: no levels are known
  double unit_m_ = 0.0;         ///< metres per unit of the last image's samples
  int images_ = 0;              ///< number of images since the unit changed
};

}  // namespace telepalp::surface
