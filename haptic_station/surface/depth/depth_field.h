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

/// Depth in metres as floats, a whole image; 0 is "not measured".
struct DepthField {
  int width = 0;
  int height = 0;
  std::vector<float> z_m;
  std::vector<float> weight;  ///< how many frames stand behind each pixel; empty: one each

  [[nodiscard]] std::size_t index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

/// What the hand can reach before the next frame.
struct Reach {
  Point<DepthCamera> centre;
  double radius_m = 0.1;
};

[[nodiscard]] DepthField to_depth_field(const DepthImage& depth);

/// Pixels on which anything within `reach` can lie, grown by `margin_px`; the whole image when there is no reach or the
/// reach holds the camera; empty when it is behind the camera or beside the image.
[[nodiscard]] PixelBox box_in_reach(const Intrinsics& camera, const std::optional<Reach>& reach, int margin_px);

/// The depth step between neighbouring pixels that ends a surface. Noise and slant both grow with distance.
[[nodiscard]] inline float break_at(float z_m, float break_at_1m) noexcept {
  return break_at_1m * (0.5F + 0.5F * z_m * z_m);
}

}  // namespace telepalp::surface
