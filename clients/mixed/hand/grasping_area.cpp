#include "clients/mixed/hand/grasping_area.h"

#include <algorithm>
#include <cmath>

#include "proto/words/smooth_step.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector2d;

/// The direction of the handle in the image; along x when the handle points at the camera.
Vector2d direction(const GraspingArea& area) noexcept {
  const Vector2d along = area.b - area.a;
  return along.norm() > 1e-6 ? Vector2d(along.normalized()) : Vector2d(Vector2d::UnitX());
}

}  // namespace

double GraspingArea::weight_at(const Vector2d& pixel) const noexcept {
  const Vector2d along = direction(*this);
  const Vector2d from_a = pixel - a;
  const double at = from_a.dot(along);
  const double beyond_px = std::max({0.0, -at, at - (b - a).norm()});
  const double across_px = std::abs(from_a.x() * along.y() - from_a.y() * along.x());
  return 1.0 - smooth_step(0.5 * inner_px, 0.5 * outer_px, across_px + beyond_px);
}

std::array<Vector2d, 6> GraspingArea::corners(double width_px) const noexcept {
  const Vector2d along = 0.5 * width_px * direction(*this);
  const Vector2d across(-along.y(), along.x());
  return {a - along, a + across, b + across, b + along, b - across, a - across};
}

std::optional<GraspingArea> grasping_area(const View& view, const Point<World>& from, const Point<World>& to) noexcept {
  const auto a = image_of(view, from);
  const auto b = image_of(view, to);
  if (!a || !b) return std::nullopt;
  const double diagonal_px = std::hypot(view.intrinsics.width, view.intrinsics.height);
  const double outer_px = std::max(0.75 * (*a - *b).norm(), 0.1 * diagonal_px);
  return GraspingArea{*a, *b, outer_px, 0.2 * outer_px};
}

}  // namespace telepalp::mixed
