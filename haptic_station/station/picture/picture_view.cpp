#include "haptic_station/station/picture/picture_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace telepalp::station {

using Eigen::Vector3d;
using solids::PictureView;

Directions directions_of(PictureSide side) {
  switch (side) {
    case PictureSide::Above:
      break;
    case PictureSide::Feet:
      return {-Vector3d::UnitZ(), Vector3d::UnitY(), "from the feet", "front", "patient's left"};
    case PictureSide::Side:
      return {-Vector3d::UnitX(), Vector3d::UnitY(), "from the patient's left", "front", "head"};
  }
  return {-Vector3d::UnitY(), -Vector3d::UnitZ(), "from above", "head", "patient's left"};
}

PictureView view_of(const std::vector<scenes::SceneObject>& objects, std::span<const SkinPoint> skin,
                    const Directions& directions, std::optional<double> width_m, int side_px) {
  constexpr double kLeast_m = 0.2;
  constexpr double kMost_m = 4.0;
  constexpr double kBorder = 1.15;
  Eigen::AlignedBox3d seen;
  for (const scenes::SceneObject& object : objects)
    if (object.tree->box().bounded()) seen.extend(Eigen::AlignedBox3d(object.tree->box().low, object.tree->box().high));
  for (const SkinPoint& point : skin) seen.extend(point.at_m);
  if (seen.isEmpty()) seen.extend(Vector3d::Zero());
  seen.extend(Vector3d(seen.center().x(), 0.0, seen.center().z()));  // the skin above the objects
  const Vector3d size = seen.sizes();
  const Vector3d right = directions.towards.cross(directions.up);
  const double extent_m = std::max(std::abs(right.dot(size)), std::abs(directions.up.dot(size)));
  return {.center = seen.center(),
          .towards = directions.towards,
          .up = directions.up,
          .width_m = width_m.value_or(std::clamp(kBorder * extent_m, kLeast_m, kMost_m)),
          .side_px = side_px};
}

Seen seen_at(const PictureView& view, const Vector3d& at_m) {
  const double px_per_m = view.side_px / view.width_m;
  const Vector3d from_center = at_m - view.center;
  return {0.5 * view.side_px + px_per_m * from_center.dot(view.towards.cross(view.up)),
          0.5 * view.side_px - px_per_m * from_center.dot(view.up), -from_center.dot(view.towards)};
}

double grid_step_m(double width_m) {
  const double tenth = std::pow(10.0, std::floor(std::log10(width_m / 4.0)));
  for (const double step : {5.0 * tenth, 2.0 * tenth})
    if (width_m / step >= 4.0) return step;
  return tenth;
}

}  // namespace telepalp::station
