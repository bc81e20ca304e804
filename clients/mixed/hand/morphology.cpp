#include "clients/mixed/hand/morphology.h"

namespace telepalp::mixed {
namespace {

/// Flood fill within `box`, from the pixels in `queue`, through pixels that are on in `mask` (`wet`) or off (not
/// `wet`). Switches on the pixels that it reaches in `flooded`.
void flood(Mask& flooded, std::vector<std::size_t>& queue, const Mask& mask, const Box& box, bool wet) {
  const auto width = static_cast<std::size_t>(mask.width);
  const auto visit = [&](std::size_t pixel) {
    if (flooded.on[pixel] != 0 || (mask.on[pixel] != 0) != wet) return;
    flooded.on[pixel] = 1;
    queue.push_back(pixel);
  };
  while (!queue.empty()) {
    const std::size_t pixel = queue.back();
    queue.pop_back();
    const int x = static_cast<int>(pixel % width), y = static_cast<int>(pixel / width);
    if (x > box.left) visit(pixel - 1);
    if (x + 1 < box.right) visit(pixel + 1);
    if (y > box.top) visit(pixel - width);
    if (y + 1 < box.bottom) visit(pixel + width);
  }
}

/// Erodes `count` lines of `length` pixels, each along itself: a pixel stays on if the `radius` pixels on both of its
/// sides are on. `line_step`: from a line's first byte to the next line's; `step`: from a pixel to the next one.
void erode_lines(std::uint8_t* first, int radius, int count, int length, std::size_t line_step, std::size_t step) {
  std::vector<std::uint8_t> line(static_cast<std::size_t>(length));
  for (int i = 0; i < count; ++i) {
    std::uint8_t* const at = first + static_cast<std::size_t>(i) * line_step;
    for (int k = 0; k < length; ++k) line[static_cast<std::size_t>(k)] = at[static_cast<std::size_t>(k) * step];
    int last_off = -radius - 1;
    int next_off = 0;
    for (int k = 0; k < length; ++k) {
      while (next_off < length && (next_off <= k || line[static_cast<std::size_t>(next_off)] != 0)) ++next_off;
      if (line[static_cast<std::size_t>(k)] == 0) last_off = k;
      const bool near_off = k - last_off <= radius || (next_off < length && next_off - k <= radius);
      if (near_off) at[static_cast<std::size_t>(k) * step] = 0;
    }
  }
}

}  // namespace

Mask reconstructed(const Mask& marker, const Mask& mask) {
  Mask flooded(mask.width, mask.height);
  std::vector<std::size_t> queue;
  const Box box = box_of(marker);
  for (int y = box.top; y < box.bottom; ++y)
    for (std::size_t i = mask.index(box.left, y);
         i < mask.index(box.left, y) + static_cast<std::size_t>(box.right - box.left); ++i)
      if (marker.on[i] != 0 && mask.on[i] != 0) {
        flooded.on[i] = 1;
        queue.push_back(i);
      }
  flood(flooded, queue, mask, {0, 0, mask.width, mask.height}, true);
  return flooded;
}

Mask with_holes_filled(const Mask& mask) {
  const Box box = box_of(mask);
  Mask outside(mask.width, mask.height);
  std::vector<std::size_t> queue;
  const auto start = [&](int x, int y) {
    if (mask.at(x, y) || outside.at(x, y)) return;
    outside.on[outside.index(x, y)] = 1;
    queue.push_back(outside.index(x, y));
  };
  for (int x = box.left; x < box.right; ++x) {
    start(x, box.top);
    start(x, box.bottom - 1);
  }
  for (int y = box.top; y < box.bottom; ++y) {
    start(box.left, y);
    start(box.right - 1, y);
  }
  flood(outside, queue, mask, box, false);
  Mask filled = mask;
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x)
      if (!outside.at(x, y)) filled.on[filled.index(x, y)] = 1;
  return filled;
}

Mask eroded(const Mask& mask, int radius_px) {
  Mask out = mask;
  if (radius_px <= 0) return out;
  // Pixels outside the box and its margin need no erosion: they are off, or beyond the image's border.
  const Box box = box_of(mask).grown(radius_px, mask.width, mask.height);
  if (box.empty()) return out;
  const auto width = static_cast<std::size_t>(mask.width);
  std::uint8_t* const first = out.on.data() + out.index(box.left, box.top);
  erode_lines(first, radius_px, box.bottom - box.top, box.right - box.left, width, 1);
  erode_lines(first, radius_px, box.right - box.left, box.bottom - box.top, 1, width);
  return out;
}

Mask cleaned(const Mask& mask, const CleanUp& how) {
  const Mask smaller = eroded(with_holes_filled(mask), how.erosion_px);
  return reconstructed(eroded(smaller, how.opening_px), smaller);
}

}  // namespace telepalp::mixed
