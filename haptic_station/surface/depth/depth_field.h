#pragma once

#include <optional>
#include <vector>

#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::surface {

/// Half-open rectangle of pixels.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  [[nodiscard]] int width() const noexcept { return right - left; }
  [[nodiscard]] int height() const noexcept { return bottom - top; }
  [[nodiscard]] bool empty() const noexcept { return right <= left || bottom <= top; }
};

/// A depth image in metres; 0 means "not measured".
struct DepthField {
  int width = 0;
  int height = 0;
  std::vector<float> z_m;
  std::vector<float> weight;  ///< number of frames averaged at each pixel; empty: one frame

  [[nodiscard]] std::size_t index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

/// The sphere that the hand can reach before the next depth frame.
struct Reach {
  Point<DepthCamera> centre;
  double radius_m = 0.1;
};

[[nodiscard]] DepthField to_depth_field(const DepthImage& depth);
/// Writes the depth image in metres to `field` and reuses its memory; the other overload returns a new field.
void to_depth_field(const DepthImage& depth, DepthField& field);

/// The bounding box of `reach` projected into the image, grown by `margin_px`. The whole image when `reach`
/// is nullopt, not finite or contains the camera; empty when the sphere lies behind the camera or outside the image.
[[nodiscard]] PixelBox box_in_reach(const Intrinsics& camera, const std::optional<Reach>& reach, int margin_px);

/// The least depth step between neighbouring pixels that counts as a depth break [m]. It grows with depth, because
/// noise and the step on a slanted surface grow, too. `break_at_1m`: its value at a depth of 1 m.
[[nodiscard]] inline float break_at(float z_m, float break_at_1m) noexcept {
  return break_at_1m * (0.5F + 0.5F * z_m * z_m);
}

}  // namespace telepalp::surface
