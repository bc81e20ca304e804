#include "proto/words/depth/depth_window.h"

#include <algorithm>
#include <cstddef>

namespace telepalp {
namespace {

/// Also false for NaN.
bool is_credible(const DepthErrorBound& bound) noexcept {
  return bound.least_m >= 0.0 && bound.least_m <= 1.0 && bound.per_m >= 0.0 && bound.per_m <= 1.0;
}

}  // namespace

std::optional<PixelRect> clipped(const PixelRect& rect, int width, int height) noexcept {
  // `rect` may come from a peer, so the sum of its place and its size may not fit an int.
  const auto within = [](std::int64_t at, int size) { return static_cast<int>(std::clamp<std::int64_t>(at, 0, size)); };
  const int left = within(rect.column, width);
  const int top = within(rect.row, height);
  const int right = within(std::int64_t{rect.column} + rect.width, width);
  const int bottom = within(std::int64_t{rect.row} + rect.height, height);
  if (right <= left || bottom <= top) return std::nullopt;
  return PixelRect{.column = left, .row = top, .width = right - left, .height = bottom - top};
}

DepthErrorBound DepthWindow::in_ring(int ring) const noexcept {
  const double share = static_cast<double>(ring) / (kRings - 1);
  return {.least_m = near.least_m + share * (border.least_m - near.least_m),
          .per_m = near.per_m + share * (border.per_m - near.per_m)};
}

int ring_on_axis(int at, int exact_first, int exact_size, int size) noexcept {
  const int exact_end = exact_first + exact_size;
  if (at >= exact_first && at < exact_end) return -1;
  const int away = at < exact_first ? exact_first - at : at - exact_end + 1;  // 1 beside the window
  const int room = at < exact_first ? exact_first : size - exact_end;         // `away` of the pixel at the border
  return (away * DepthWindow::kRings + room - 1) / room - 1;
}

std::optional<DepthErrorBound> bound_at(const DepthWindow& window, int width, int height, int column,
                                        int row) noexcept {
  const PixelRect& exact = window.exact;
  const int ring = std::max(ring_on_axis(column, exact.column, exact.width, width),
                            ring_on_axis(row, exact.row, exact.height, height));
  return ring < 0 ? std::nullopt : std::optional(window.in_ring(ring));
}

bool is_well_formed(const DepthWindow& window, int width, int height) noexcept {
  const bool grows = window.near.least_m <= window.border.least_m && window.near.per_m <= window.border.per_m;
  return clipped(window.exact, width, height) == window.exact && is_credible(window.near) &&
         is_credible(window.border) && grows;
}

void keep_only(DepthImage& depth, const PixelRect& exact) noexcept {
  for (int row = 0; row < depth.height; ++row) {
    const auto begin = depth.samples.begin() + std::ptrdiff_t{row} * depth.width;
    const auto end = begin + depth.width;
    if (row < exact.row || row >= exact.row + exact.height) {
      std::fill(begin, end, std::uint16_t{0});
      continue;
    }
    std::fill(begin, begin + exact.column, std::uint16_t{0});
    std::fill(begin + exact.column + exact.width, end, std::uint16_t{0});
  }
}

}  // namespace telepalp
