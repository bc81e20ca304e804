#include "clients/mixed/device/device_mask.h"

#include <cmath>
#include <numbers>

namespace telepalp::mixed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// One of the balls whose convex hull is a body, in the camera's frame.
struct Ball {
  Vector3d eye_m;
  double radius_m;
};

constexpr int kSides = 12;  // number of sides of the polygon that is circumscribed about a circle

void add_circle(std::vector<Vector2d>& points, const Vector2d& centre_px, double radius_px) {
  const double outside_px = radius_px / std::cos(std::numbers::pi / kSides);
  for (int i = 0; i < kSides; ++i) {
    const double at = 2.0 * std::numbers::pi * i / kSides;
    points.emplace_back(centre_px + outside_px * Vector2d(std::cos(at), std::sin(at)));
  }
}

/// Switches on the image of the convex hull of `balls`. A ball nearer than kNearest_m, or behind the camera, is
/// replaced by the points where the lines from its centre to those of the other balls cross the plane at kNearest_m.
void fill_balls(Mask& mask, const std::vector<Ball>& balls, const Intrinsics& lens) {
  const double focal_px = std::max(lens.fx, lens.fy);
  std::vector<Vector2d> points;
  for (const Ball& ball : balls) {
    if (const auto at = image_of(lens, Point<Eye>{ball.eye_m})) {
      add_circle(points, *at, focal_px * ball.radius_m / ball.eye_m.z());
      continue;
    }
    for (const Ball& other : balls) {
      if (other.eye_m.z() <= kNearest_m) continue;
      const double along = (kNearest_m * 1.001 - ball.eye_m.z()) / (other.eye_m.z() - ball.eye_m.z());
      const Vector3d cut = ball.eye_m + along * (other.eye_m - ball.eye_m);
      if (const auto at = image_of(lens, Point<Eye>{cut})) points.push_back(*at);
    }
  }
  fill_hull(mask, points);
}

std::vector<Vector3d> corners_of(const Prism& prism, double share) {
  std::vector<Vector3d> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const Vector3d side(i & 1U ? 1.0 : -1.0, i & 2U ? 1.0 : -1.0, i & 4U ? 1.0 : -1.0);
    corners.emplace_back(prism.centre_m + (1.0 + share) * side.cwiseProduct(prism.half_m));
  }
  return corners;
}

/// Points around the rims of the cone.
std::vector<Vector3d> rims_of(const Cone& cone, double share) {
  const Vector3d axis = cone.to_m - cone.from_m;
  const Vector3d across = axis.unitOrthogonal();
  const Vector3d other = axis.normalized().cross(across);
  std::vector<Vector3d> rims;
  const double more = (1.0 + share) / std::cos(std::numbers::pi / kSides);
  for (int i = 0; i < kSides; ++i) {
    const double at = 2.0 * std::numbers::pi * i / kSides;
    const Vector3d out = more * (std::cos(at) * across + std::sin(at) * other);
    rims.emplace_back(cone.from_m - 0.5 * share * axis + cone.from_radius_m * out);
    rims.emplace_back(cone.to_m + 0.5 * share * axis + cone.to_radius_m * out);
  }
  return rims;
}

}  // namespace

double MaskMargin::at_m(const Vector3d& haptic_m) const noexcept {
  return std::hypot(least_m, per_m * (haptic_m - centre.m).norm());
}

MaskMargin paper_margin() noexcept { return {.share = 0.05, .least_m = 0.0, .per_m = 0.0, .centre = {}}; }

MaskMargin calibrated_margin(double deviation_m, double turn_rad, const Point<HapticBase>& centre) noexcept {
  return {.share = 0.0, .least_m = 3.0 * deviation_m, .per_m = 3.0 * turn_rad, .centre = centre};
}

std::pair<Point<World>, Point<World>> StandingDevice::handle() const {
  const Eigen::Isometry3d world_from_handle = world_from_haptic.iso * base_from_frames(model, joints_rad).back();
  return {{world_from_handle * model.handle.from_m}, {world_from_handle * model.handle.to_m}};
}

Mask device_mask(const StandingDevice& device, const View& view, const MaskMargin& margin) {
  const std::vector<Eigen::Isometry3d> frames = base_from_frames(device.model, device.joints_rad);
  const Eigen::Isometry3d eye_from_haptic = view.world_from_eye.iso.inverse() * device.world_from_haptic.iso;
  Mask mask(view.intrinsics.width, view.intrinsics.height);
  const auto fill = [&](const std::vector<Vector3d>& corners, const Eigen::Isometry3d& base_from_body) {
    std::vector<Ball> balls;
    for (const Vector3d& corner : corners) {
      const Vector3d haptic_m = base_from_body * corner;
      balls.push_back({eye_from_haptic * haptic_m, margin.at_m(haptic_m)});
    }
    fill_balls(mask, balls, view.intrinsics);
  };
  for (const Prism& prism : device.model.prisms) fill(corners_of(prism, margin.share), frames[prism.frame]);
  fill(rims_of(device.model.handle, margin.share), frames.back());
  return mask;
}

Mask cone_mask(const View& view, const Point<World>& from, const Point<World>& to, double from_radius_m,
               double to_radius_m) {
  Mask mask(view.intrinsics.width, view.intrinsics.height);
  std::vector<Ball> balls;
  for (const Vector3d& rim : rims_of({from.m, to.m, from_radius_m, to_radius_m}, 0.0))
    balls.push_back({view.world_from_eye.iso.inverse() * rim, 0.0});
  fill_balls(mask, balls, view.intrinsics);
  return mask;
}

}  // namespace telepalp::mixed
