#include "clients/mixed/compose/ghost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clients/mixed/hand/morphology.h"

namespace telepalp::mixed {

double free_hand_m(const Mask& hand, const Mask& device_at, const StandingDevice& device, const GraspingArea& grasp,
                   const View& view) {
  constexpr int kMostReach_px = 80;  // of distance_outside(), which ends at 255 thirds of a pixel
  Mask grasped(hand.width, hand.height);
  fill_hull(grasped, grasp.corners(grasp.inner_px));
  const Mask holding = reconstructed(both(hand, grasped), hand);
  const Point<World> handle = device.handle().first;
  const double away_m = (view.world_from_eye.iso.inverse() * handle.m).z();
  const double m_per_px = std::max(away_m, kNearest_m) / view.intrinsics.fx;
  const int reach_px = std::clamp(static_cast<int>(kGhostReach_m / m_per_px), 1, kMostReach_px);
  const std::vector<std::uint8_t> distance = distance_outside(device_at, reach_px);
  int least = 255;
  for (std::size_t i = 0; i < hand.on.size(); ++i)
    if (hand.on[i] != 0 && holding.on[i] == 0) least = std::min<int>(least, distance[i]);
  return least == 255 ? std::numeric_limits<double>::infinity() : least / 3.0 * m_per_px;
}

double joint_room(const StandingDevice& device) noexcept {
  double room = 0.5;
  for (std::size_t i = 0; i < device.model.joints.size(); ++i) {
    const Joint& joint = device.model.joints[i];
    const double nearest = std::min(device.joints_rad[i] - joint.least_rad, joint.most_rad - device.joints_rad[i]);
    room = std::min(room, std::max(0.0, nearest) / (joint.most_rad - joint.least_rad));
  }
  return room;
}

void draw_ghost(ColorImage& image, const ColorImage& live, const Mask& where, double opacity) {
  for (std::size_t i = 0; i < where.on.size(); ++i)
    for (std::size_t c = 3 * i; where.on[i] != 0 && c < 3 * i + 3; ++c)
      image.rgb[c] = static_cast<std::uint8_t>(std::lround(std::lerp(1.0 * image.rgb[c], 1.0 * live.rgb[c], opacity)));
}

}  // namespace telepalp::mixed
