#include "proto/words/rgbd_frame.h"

#include <cmath>

namespace telepalp {
namespace {

bool side_in_bounds(int side) noexcept { return side > 0 && side <= kMaxImageSide; }

std::size_t pixel_count(int width, int height) noexcept {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

bool is_finite_positive(double value) noexcept { return std::isfinite(value) && value > 0.0; }

}  // namespace

bool is_well_formed(const DepthImage& depth) noexcept {
  return side_in_bounds(depth.width) && side_in_bounds(depth.height) && is_finite_positive(depth.unit_m) &&
         depth.samples.size() == pixel_count(depth.width, depth.height);
}

bool is_well_formed(const ColorImage& color) noexcept {
  if (color.width == 0 && color.height == 0) return color.rgb.empty();
  return side_in_bounds(color.width) && side_in_bounds(color.height) &&
         color.rgb.size() == 3 * pixel_count(color.width, color.height);
}

bool is_well_formed(const Intrinsics& intrinsics) noexcept {
  return side_in_bounds(intrinsics.width) && side_in_bounds(intrinsics.height) && is_finite_positive(intrinsics.fx) &&
         is_finite_positive(intrinsics.fy) && std::isfinite(intrinsics.cx) && std::isfinite(intrinsics.cy);
}

bool is_well_formed(const RgbdFrame& frame) noexcept {
  return is_well_formed(frame.depth) && is_well_formed(frame.color) && is_well_formed(frame.camera.depth) &&
         frame.camera.depth.width == frame.depth.width && frame.camera.depth.height == frame.depth.height;
}

}  // namespace telepalp
