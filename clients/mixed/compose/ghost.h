#pragma once

#include "clients/mixed/device/device_mask.h"
#include "clients/mixed/hand/grasping_area.h"
#include "clients/mixed/view/mask.h"

namespace telepalp::mixed {

/// The distance in the image of the nearest hand that does not hold the handle from the device, in metres at the
/// device's distance from the camera. Infinity: no such hand within kGhostReach_m. A hand holds the handle if it is
/// joined to the middle of the grasping area. `device_at`: the device's mask.
[[nodiscard]] double free_hand_m(const Mask& hand, const Mask& device_at, const StandingDevice& device,
                                 const GraspingArea& grasp, const View& view);
inline constexpr double kGhostReach_m = 0.15;

/// How far the joint that is nearest to an end of its range is from it, as a share of the range; 0 at or beyond an end.
[[nodiscard]] double joint_room(const StandingDevice& device) noexcept;

/// Draws `live` over `image` where `where` is on, with an opacity from 0 to 1.
void draw_ghost(ColorImage& image, const ColorImage& live, const Mask& where, double opacity);

}  // namespace telepalp::mixed
