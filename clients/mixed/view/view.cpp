#include "clients/mixed/view/view.h"

namespace telepalp::mixed {

std::optional<Eigen::Vector2d> image_of(const Intrinsics& intrinsics, const Point<Eye>& point) noexcept {
  if (!(point.m.z() >= kNearest_m)) return std::nullopt;
  return Eigen::Vector2d(intrinsics.fx * point.m.x() / point.m.z() + intrinsics.cx,
                         intrinsics.fy * point.m.y() / point.m.z() + intrinsics.cy);
}

std::optional<Eigen::Vector2d> image_of(const View& view, const Point<World>& point) noexcept {
  return image_of(view.intrinsics, view.world_from_eye.inverse() * point);
}

}  // namespace telepalp::mixed
