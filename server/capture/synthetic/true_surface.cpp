#include "server/capture/synthetic/true_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace telepalp::server {
namespace {

struct Pixel {
  double u;
  double v;
};
Pixel project(const Intrinsics& camera, const Eigen::Vector3d& m) noexcept {
  return {camera.fx * m.x() / m.z() + camera.cx, camera.fy * m.y() / m.z() + camera.cy};
}

constexpr int kMaxSteps = 60;

}  // namespace

TrueSurface::TrueSurface(std::shared_ptr<const RestShape> rest, Breath breath) noexcept
    : rest_(std::move(rest)), breath_(breath) {}

TrueSurfacePoint TrueSurface::on_layer(double u, double v, bool body) const noexcept {
  const Intrinsics& camera = rest_->camera;
  const Eigen::Vector3d ray{(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0};
  if (!body)
    return {.at = {ray * rest_->table_depth_m},
            .normal = {-Eigen::Vector3d::UnitZ()},
            .velocity_m_per_s = {},
            .normal_velocity_m_per_s = 0.0,
            .on_body = false};
  const ImageField::Sample rest = rest_->body_depth_m.at(u, v);
  const ImageField::Sample share = rest_->lift_share(u, v);
  const double z = rest.value - breath_.lift_m * share.value;
  // P(u, v) = z ray. Its tangents are dz/du ray + z/fx e_x and dz/dv ray + z/fy e_y; their cross product, turned
  // towards the pinhole and divided by z / (fx fy):
  const double across = (rest.du - breath_.lift_m * share.du) * camera.fx;
  const double down = (rest.dv - breath_.lift_m * share.dv) * camera.fy;
  const Eigen::Vector3d normal = Eigen::Vector3d{across, down, -z - across * ray.x() - down * ray.y()}.normalized();
  const Eigen::Vector3d velocity = -breath_.speed_m_per_s * share.value * ray;
  return {.at = {ray * z},
          .normal = {normal},
          .velocity_m_per_s = {velocity},
          .normal_velocity_m_per_s = velocity.dot(normal),
          .on_body = true};
}

TrueSurfacePoint TrueSurface::at_pixel(double u, double v) const noexcept {
  return on_layer(u, v, rest_->meets_body(u, v));
}

TrueSurfacePoint TrueSurface::on_ray_through(const Point<DepthCamera>& point) const noexcept {
  const Pixel pixel = project(rest_->camera, point.m);
  return at_pixel(pixel.u, pixel.v);
}

std::optional<TrueSurfacePoint> TrueSurface::at_xy(double x_m, double y_m) const noexcept {
  // Newton on z: the tangent plane at the ray's hit, met by the parallel to the axis through (x, y).
  Eigen::Vector3d guess{x_m, y_m, rest_->view_depth_m};
  for (int step = 0; step < kMaxSteps; ++step) {
    const TrueSurfacePoint hit = on_ray_through({guess});
    if (std::abs(hit.normal.v.z()) < 1e-3) return std::nullopt;
    const double off = (hit.at.m - guess).dot(hit.normal.v) / hit.normal.v.z();
    if (std::abs(hit.at.m.x() - x_m) + std::abs(hit.at.m.y() - y_m) < 1e-9) return hit;
    guess.z() = std::clamp(guess.z() + off, 0.5 * rest_->view_depth_m, 2.0 * rest_->table_depth_m);
  }
  return std::nullopt;
}

std::optional<TrueSurfacePoint> TrueSurface::closest_to(const Point<DepthCamera>& point) const noexcept {
  const Pixel first = project(rest_->camera, point.m);
  const bool body = rest_->meets_body(first.u, first.v);
  TrueSurfacePoint foot = on_layer(first.u, first.v, body);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Eigen::Vector3d from_foot = point.m - foot.at.m;
    const Eigen::Vector3d along_tangent = from_foot - from_foot.dot(foot.normal.v) * foot.normal.v;
    if (along_tangent.norm() < 1e-8) return foot;
    const Eigen::Vector3d next = foot.at.m + along_tangent;
    if (next.z() < 0.1 * rest_->view_depth_m) return std::nullopt;
    const Pixel pixel = project(rest_->camera, next);
    foot = on_layer(pixel.u, pixel.v, body);
    if (body && !rest_->meets_body(pixel.u, pixel.v)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> TrueSurface::signed_distance_m(const Point<DepthCamera>& point) const noexcept {
  const std::optional<TrueSurfacePoint> foot = closest_to(point);
  if (!foot) return std::nullopt;
  return (point.m - foot->at.m).dot(foot->normal.v);
}

}  // namespace telepalp::server
