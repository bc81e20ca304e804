#include "clients/mixed/compose/ghost.h"

#include <algorithm>
#include <cmath>

namespace telepalp::mixed {

double joint_room(const StandingDevice& device) noexcept {
  double room = 0.5;
  for (std::size_t i = 0; i < device.model.joints.size(); ++i) {
    const Joint& joint = device.model.joints[i];
    const double nearest = std::min(device.joints_rad[i] - joint.least_rad, joint.most_rad - device.joints_rad[i]);
    room = std::min(room, std::max(0.0, nearest) / (joint.most_rad - joint.least_rad));
  }
  return room;
}

std::uint8_t blended(std::uint8_t under, std::uint8_t over, double opacity) noexcept {
  return static_cast<std::uint8_t>(std::lround(std::lerp(1.0 * under, 1.0 * over, opacity)));
}

void draw_ghost(ColorImage& image, const ColorImage& live, const Mask& where, double opacity) {
  for (std::size_t i = 0; i < where.on.size(); ++i)
    for (std::size_t c = 3 * i; where.on[i] != 0 && c < 3 * i + 3; ++c)
      image.rgb[c] = blended(image.rgb[c], live.rgb[c], opacity);
}

}  // namespace telepalp::mixed
