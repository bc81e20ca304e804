#pragma once

#include <algorithm>
#include <cmath>

#include "clients/ar/view_camera.h"

namespace telepalp::ar {

/// Rasterises a triangle: calls `pixel(x, y, wa, wb, wc)`, with the barycentric weights of a, b and c, for each pixel
/// whose centre lies in the triangle. The image has `width` × `height` pixels. A triangle that reaches behind the near
/// plane or has no area is not drawn.
template <class PixelFunction>
void scan(const Projected& a, const Projected& b, const Projected& c, int width, int height, PixelFunction pixel) {
  if (!a.visible || !b.visible || !c.visible) return;
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(std::abs(area) > 1e-9F)) return;
  const auto clamped = [](float value, int most) {
    return static_cast<int>(std::clamp(value, -1.0F, static_cast<float>(most)));
  };
  const int left = std::max(0, clamped(std::floor(std::min({a.x, b.x, c.x}) - 0.5F), width));
  const int right = std::min(width - 1, clamped(std::ceil(std::max({a.x, b.x, c.x})), width));
  const int top = std::max(0, clamped(std::floor(std::min({a.y, b.y, c.y}) - 0.5F), height));
  const int bottom = std::min(height - 1, clamped(std::ceil(std::max({a.y, b.y, c.y})), height));
  const float per_area = 1.0F / area;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
      const float wb = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) * per_area;
      const float wc = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) * per_area;
      const float wa = 1.0F - wb - wc;
      if (wa >= 0.0F && wb >= 0.0F && wc >= 0.0F) pixel(x, y, wa, wb, wc);
    }
}

}  // namespace telepalp::ar
