#pragma once

#include <algorithm>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/grid/window_mask.h"

namespace telepalp::surface {

/// The pixels of a box, with a margin within the image: their inverse depth, the links between neighbours, and a
/// summed-area table of the pixels that a complete window must not contain.
struct InverseCrop {
  InverseCrop(const PixelBox& box, int image_width, int image_height, int margin)
      : left(std::max(0, box.left - margin)),
        top(std::max(0, box.top - margin)),
        width(std::min(image_width, box.right + margin) - left),
        height(std::min(image_height, box.bottom + margin) - top),
        per_m(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + kBlock),
        measured(width, height),
        right(width, height),
        below(width, height),
        troubles(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1)) {}

  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  float reference_per_m = 0.0F;
  std::vector<float> per_m;  ///< inverse depth minus the reference
  BitRows measured;
  BitRows right;              ///< linked to the right neighbour
  BitRows below;              ///< linked to the one below
  std::vector<int> troubles;  ///< summed-area table, (width + 1) × (height + 1)

  [[nodiscard]] std::size_t at(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] int troubles_at(int column, int row) const noexcept {
    return troubles[static_cast<std::size_t>(row) * static_cast<std::size_t>(width + 1) +
                    static_cast<std::size_t>(column)];
  }
  [[nodiscard]] bool is_whole(int column, int row, int radius) const noexcept {
    return column >= radius && row >= radius && column + radius < width && row + radius < height &&
           troubles_at(column + radius + 1, row + radius + 1) + troubles_at(column - radius, row - radius) ==
               troubles_at(column - radius, row + radius + 1) + troubles_at(column + radius + 1, row - radius);
  }
  [[nodiscard]] InverseDepthView view() const noexcept {
    return {width, height, per_m, measured, right, below, reference_per_m};
  }
};

/// `break_m`: as in FitSettings.
[[nodiscard]] InverseCrop crop_of(const DepthField& depth, const PixelBox& box, int margin_px, double break_m);

}  // namespace telepalp::surface
