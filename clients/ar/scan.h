#pragma once

#include "clients/ar/view_camera.h"
#include "support/images/triangle_scan.h"

namespace telepalp::ar {

/// images::scan_triangle() for a projected triangle. A triangle that reaches behind the near plane is not drawn.
template <class PixelFunction>
void scan(const Projected& a, const Projected& b, const Projected& c, int width, int height, PixelFunction pixel) {
  if (!a.visible || !b.visible || !c.visible) return;
  const auto at = [](const Projected& corner) { return Eigen::Vector2f(corner.x - 0.5F, corner.y - 0.5F); };
  images::scan_triangle(at(a), at(b), at(c), width, height, pixel);
}

}  // namespace telepalp::ar
