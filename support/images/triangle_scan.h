#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace telepalp::images {

/// Rasterises a triangle: calls `pixel(x, y, wa, wb, wc)`, with the barycentric weights of a, b and c in the image, for
/// each pixel of a `width` x `height` image whose centre lies in the triangle. Corners in pixels; the centre of the
/// first pixel is (0, 0). A triangle without area, or with a corner that is not a number, has no pixel.
template <class PixelFunction>
void scan_triangle(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c, int width, int height,
                   PixelFunction pixel) {
  const float area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
  if (!(std::abs(area) >= 1e-6F)) return;
  // The clamp comes before the conversion: an int cannot hold every float.
  const auto first = [](float least, int size) {
    return static_cast<int>(std::clamp(std::ceil(least), 0.0F, static_cast<float>(size)));
  };
  const auto end = [](float most, int size) {
    return static_cast<int>(std::clamp(std::floor(most), -1.0F, static_cast<float>(size - 1))) + 1;
  };
  const int right = end(std::max({a.x(), b.x(), c.x()}), width);
  const int bottom = end(std::max({a.y(), b.y(), c.y()}), height);
  for (int y = first(std::min({a.y(), b.y(), c.y()}), height); y < bottom; ++y)
    for (int x = first(std::min({a.x(), b.x(), c.x()}), width); x < right; ++x) {
      const float px = static_cast<float>(x), py = static_cast<float>(y);
      const float wb = ((px - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (py - a.y())) / area;
      const float wc = ((b.x() - a.x()) * (py - a.y()) - (px - a.x()) * (b.y() - a.y())) / area;
      if (wb >= 0.0F && wc >= 0.0F && wb + wc <= 1.0F) pixel(x, y, 1.0F - wb - wc, wb, wc);
    }
}

}  // namespace telepalp::images
