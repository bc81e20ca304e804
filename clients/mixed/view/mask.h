#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace telepalp::mixed {

/// One byte for each pixel, rows top to bottom: 0 outside, otherwise inside.
struct Mask {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> on;

  Mask() = default;
  Mask(int width_px, int height_px, std::uint8_t value = 0)
      : width(width_px),
        height(height_px),
        on(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), value) {}
  [[nodiscard]] std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool at(int x, int y) const noexcept { return on[index(x, y)] != 0; }
  [[nodiscard]] bool contains(int x, int y) const noexcept { return x >= 0 && y >= 0 && x < width && y < height; }
  [[nodiscard]] std::size_t count() const noexcept;
};

/// Columns [left, right) and rows [top, bottom) of an image.
struct Box {
  int left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] bool empty() const noexcept { return left >= right || top >= bottom; }
  /// The box with `by_px` more on each side, cut to an image of this size.
  [[nodiscard]] Box grown(int by_px, int width, int height) const noexcept;
};

/// The smallest box around the pixels that are on; empty for an empty mask.
[[nodiscard]] Box box_of(const Mask& mask) noexcept;

/// Switches on each pixel of `mask` that is on in `more`. Both have the same size.
void add(Mask& mask, const Mask& more) noexcept;

/// The pixels that are on in both masks. Both have the same size.
[[nodiscard]] Mask both(const Mask& one, const Mask& other);

/// Switches on each pixel whose centre lies in the convex hull of `points` [px].
void fill_hull(Mask& mask, std::span<const Eigen::Vector2d> points);

/// The distance of each pixel from the mask, in thirds of a pixel: 0 inside the mask, at most 255. It is the length of
/// the shortest path of steps to neighbours, 1 px for a straight step and 4/3 px for a diagonal one. A pixel more than
/// `radius_px` (0 to 250) columns or rows outside the mask's box has 255.
[[nodiscard]] std::vector<std::uint8_t> distance_outside(const Mask& mask, int radius_px);

}  // namespace telepalp::mixed
