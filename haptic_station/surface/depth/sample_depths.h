#pragma once

#include <optional>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/depth/disparity_levels.h"

namespace telepalp::surface {

/// Converts samples to depth. If the images themselves show that the camera measures disparity in whole steps, each
/// sample is replaced by the exact depth of its disparity step; otherwise its rounded depth is used. One image in 32 is
/// checked again, so that a change of the camera is noticed. Owner: surface thread.
class SampleDepths {
 public:
  /// The depths of the next image of the stream.
  [[nodiscard]] DepthField field_of(const DepthImage& depth);
  /// As above, but writes to `field` and reuses its memory.
  void field_of(const DepthImage& depth, DepthField& field);

  /// The depth levels of the camera's disparity steps; nullopt: none are known.
  [[nodiscard]] const std::optional<DisparityLevels>& levels() const noexcept { return levels_; }

 private:
  void check(const DepthImage& depth);
  void use(const std::optional<DisparityLevels>& levels);

  std::optional<DisparityLevels> levels_;
  std::vector<float> depth_m_;  ///< depth by sample value; empty: no levels are known
  double unit_m_ = 0.0;         ///< unit of the last image
  int images_ = 0;              ///< number of images since the unit changed
};

}  // namespace telepalp::surface
