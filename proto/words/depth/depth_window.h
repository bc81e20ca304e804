#pragma once

#include <optional>

#include "proto/words/rgbd_frame.h"

namespace telepalp {

/// A rectangle of pixels; `column` and `row` are those of its first pixel.
struct PixelRect {
  int column = 0;
  int row = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] bool contains(int at_column, int at_row) const noexcept {
    return at_column >= column && at_row >= row && at_column < column + width && at_row < row + height;
  }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// `rect` without its part outside an image of `width` x `height` pixels; nullopt if nothing is left.
[[nodiscard]] std::optional<PixelRect> clipped(const PixelRect& rect, int width, int height) noexcept;

/// Where a depth image is exact, and how far it may be off elsewhere. Around the window lie kRings rings. The bound is
/// `near` in the innermost ring, `border` in the outermost one, which touches the image's border, and grows by equal
/// amounts between them.
struct DepthWindow {
  static constexpr int kRings = 8;

  PixelRect exact;
  DepthErrorBound near;
  DepthErrorBound border;

  /// The bound in ring 0 to kRings - 1.
  [[nodiscard]] DepthErrorBound in_ring(int ring) const noexcept;
  friend bool operator==(const DepthWindow&, const DepthWindow&) = default;
};

/// The ring of a pixel on an axis with `size` pixels, of which `exact_size` from `exact_first` on are exact; -1 for
/// these. On each side of the window, the pixels up to the border are divided evenly among the rings.
[[nodiscard]] int ring_on_axis(int at, int exact_first, int exact_size, int size) noexcept;

/// The bound on the error of one pixel of an image of `width` x `height` pixels; nullopt: the pixel is exact. The
/// pixel's ring is the outer one of its two rings on the axes.
[[nodiscard]] std::optional<DepthErrorBound> bound_at(const DepthWindow& window, int width, int height, int column,
                                                      int row) noexcept;

/// True when the window lies within an image of `width` x `height` pixels, has at least one pixel, and its bounds are
/// from 0 to 1 m and do not shrink towards the border. False for NaN.
[[nodiscard]] bool is_well_formed(const DepthWindow& window, int width, int height) noexcept;

/// Sets all samples of `depth` outside `exact` to "not measured".
void keep_only(DepthImage& depth, const PixelRect& exact) noexcept;

}  // namespace telepalp
