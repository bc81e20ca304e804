#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "haptic_station/surface/grid/window_moments.h"

namespace telepalp::surface {

// Sums over the pixels around a node, as points of the skin. In the image a slanted skin is far from a quadratic: at a
// silhouette its depth has an infinite slope. As a height over its own tangent plane it is close to one at any slant.

/// A tangent plane of the skin, in the depth camera's frame. The axes are divided by the radius of the window [1/m], so
/// coordinates in this frame are at most 1 within the window.
struct SkinFrame {
  std::array<float, 3> at{};  ///< [m]
  std::array<float, 3> across{};
  std::array<float, 3> down{};
  std::array<float, 3> outwards{};
};

/// A rectangle of pixels in an image of inverse depths, whose rows are `stride` floats apart.
struct SkinWindow {
  const float* image = nullptr;  ///< inverse depth minus `reference_per_m` [1/m]
  std::ptrdiff_t first = 0;      ///< index in `image` of the top left pixel of the masks
  std::ptrdiff_t stride = 0;
  const std::uint32_t* mask = nullptr;  ///< one word per row; bit k selects column k
  int left = 0, right = 0;              ///< half-open columns that are read; up to kBlock more are read behind the end
  int top = 0, bottom = 0;              ///< half-open rows that are read
  float reference_per_m = 0.0F;
  float ray_x = 0.0F, ray_y = 0.0F;            ///< ray at 1 m depth of the top left pixel of the masks [m]
  float ray_x_step = 0.0F, ray_y_step = 0.0F;  ///< its change per column and per row [m]
};

/// Sums over the selected pixels, with the coordinates u (across), v (down) and h (outwards) of each pixel's point, and
/// the weight (1 - u² - v² - h²)², or 0 outside the unit ball.
struct SkinMoments {
  /// Sums of the weight times 1, u, v, u², uv, v², u³, u²v, uv², v³, u⁴, u³v, u²v², uv³ and v⁴.
  std::array<double, 15> weight{};
  std::array<double, 6> height{};  ///< sums of the weight times h times 1, u, v, u², uv and v²
};

/// Each processor gives equal bits.
void sum_on_skin(const SkinWindow& window, const SkinFrame& frame, SkinMoments& sums);

}  // namespace telepalp::surface
