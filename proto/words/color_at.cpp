#include "proto/words/color_at.h"

#include <algorithm>
#include <cmath>

namespace telepalp {

std::array<std::uint8_t, 3> color_at(const RgbdFrame& frame, int column, int row) noexcept {
  const ColorImage& color = frame.color;
  double u = column, v = row;
  if (frame.camera.color_registered) {
    u *= static_cast<double>(color.width) / frame.depth.width;
    v *= static_cast<double>(color.height) / frame.depth.height;
  } else {
    const Intrinsics &from = frame.camera.depth, &to = frame.camera.color;
    u = (u - from.cx) / from.fx * to.fx + to.cx;
    v = (v - from.cy) / from.fy * to.fy + to.cy;
  }
  const int x = std::clamp(static_cast<int>(std::lround(u)), 0, color.width - 1);
  const int y = std::clamp(static_cast<int>(std::lround(v)), 0, color.height - 1);
  const std::uint8_t* rgb = &color.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(color.width) +
                                            static_cast<std::size_t>(x))];
  return {rgb[0], rgb[1], rgb[2]};
}

}  // namespace telepalp
