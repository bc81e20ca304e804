#pragma once

#include <optional>
#include <span>
#include <vector>

#include "haptic_station/scenes/scene_objects.h"
#include "haptic_station/solids/solid_picture.h"
#include "haptic_station/station/picture/scene_picture.h"

namespace telepalp::station {

/// The axes of a picture from one side, in H, and the words for the body's directions at its top and right edges.
struct Directions {
  Eigen::Vector3d towards;  ///< unit, from the eye into the scene
  Eigen::Vector3d up;       ///< unit, upwards in the picture
  const char* name;
  const char* at_top;
  const char* at_right;
};
[[nodiscard]] Directions directions_of(PictureSide side);

/// A view that shows all of `skin` and all objects that have bounds; 0.2 to 4 m wide unless `width_m` is given.
[[nodiscard]] solids::PictureView view_of(const std::vector<scenes::SceneObject>& objects,
                                          std::span<const SkinPoint> skin, const Directions& directions,
                                          std::optional<double> width_m, int side_px);

/// Where a point is in a picture, from the top left corner [px], and how much nearer to the eye it is than the view's
/// centre [m].
struct Seen {
  double x;
  double y;
  double nearness_m;
};
[[nodiscard]] Seen seen_at(const solids::PictureView& view, const Eigen::Vector3d& at_m);

/// The step of a grid: 1, 2 or 5 times a power of ten, so that 4 to 10 steps fit into the width.
[[nodiscard]] double grid_step_m(double width_m);

}  // namespace telepalp::station
