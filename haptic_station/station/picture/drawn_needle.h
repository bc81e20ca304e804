#pragma once

#include "haptic_station/scenes/scene_objects.h"
#include "haptic_station/solids/solid_picture.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// Draws the needle over a square picture of `view`.
void draw_needle(ColorImage& picture, const solids::PictureView& view, const scenes::SceneNeedle& needle);

}  // namespace telepalp::station
