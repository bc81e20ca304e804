#pragma once

#include "clients/mixed/hand/grasping_area.h"
#include "clients/mixed/view/mask.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::mixed {

/// Draws the hand of the live image over `image`, in front of all else. In the grasping area it is moved by `shift_px`
/// with the area's weight; the arm outside stays, and the two are blended. Paper S3 (docs/sources.md) 7. `grasp`: the
/// area around the handle in the live image, before the shift. All images have the same size.
void draw_hand(ColorImage& image, const ColorImage& live, const Mask& hand, const GraspingArea& grasp,
               const Eigen::Vector2d& shift_px);

}  // namespace telepalp::mixed
