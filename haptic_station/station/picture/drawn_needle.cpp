#include "haptic_station/station/picture/drawn_needle.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/station/picture/picture_view.h"
#include "haptic_station/station/picture/pixels.h"

namespace telepalp::station {

void draw_needle(ColorImage& picture, const solids::PictureView& view, const scenes::SceneNeedle& needle) {
  constexpr int kThick_px = 3;
  const double scale = static_cast<double>(picture.width) / view.side_px;
  const Seen tip = seen_at(view, needle.tip_m);
  const Seen held = seen_at(view, needle.held_m);
  const int steps = 1 + static_cast<int>(scale * std::hypot(held.x - tip.x, held.y - tip.y));
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const int x = static_cast<int>(std::lround(scale * (tip.x + share * (held.x - tip.x))));
    const int y = static_cast<int>(std::lround(scale * (tip.y + share * (held.y - tip.y))));
    const int thick_px = i < 2 * kThick_px ? 1 : kThick_px;  // a fine tip
    if (x < kThick_px || y < kThick_px || x >= picture.width - kThick_px || y >= picture.height - kThick_px) continue;
    images::fill(picture, {x - thick_px / 2, y - thick_px / 2, thick_px, thick_px}, kInk);
  }
}

}  // namespace telepalp::station
