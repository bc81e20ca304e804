#include "server/capture/synthetic/true_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace telepalp::capture {
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

TrueSurface::TrueSurface(std::shared_ptr<const RestShape> rest, const PatientPose& pose) noexcept
    : rest_(std::move(rest)), pose_(pose) {}

TrueSurfacePoint TrueSurface::on_layer(double u, double v, bool body) const noexcept {
  const Intrinsics& camera = rest_->camera;
  const Eigen::Vector3d ray{(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0};
  if (!body)
    return {.at = {ray * rest_->table_depth_m},
            .normal = {-Eigen::Vector3d::UnitZ()},
            .velocity_m_per_s = {},
            .normal_velocity_m_per_s = 0.0,
            .on_body = false};
  const Eigen::Vector2d still = rest_->at_rest(u, v, pose_.slide_m);
  const ImageField::Sample rest = rest_->body_depth_m.at(still.x(), still.y());
  const ImageField::Sample share = rest_->lift_share(still.x(), still.y());
  const BodyRise rise = body_rise(pose_, rest_->body_coordinates_m(u, v).x());
  const double lift_m = pose_.breath.lift_m;
  const double z = rest.value - lift_m * share.value - rise.m;
  const double du = rest.du - lift_m * share.du;  // derivative of the shape at rest, which slides over the image
  const double dv = rest.dv - lift_m * share.dv;
  const double m_per_px = rest_->view_depth_m / camera.fx;
  // P(u, v) = z ray. Its tangents are dz/du ray + z/fx e_x and dz/dv ray + z/fy e_y; their cross product, turned
  // towards the pinhole and divided by z / (fx fy):
  const double z_du = du + rise.per_m * m_per_px;  // the body's coordinate falls with u
  const double across = z_du * camera.fx;
  const double down = dv * camera.fy;
  const Eigen::Vector3d normal = Eigen::Vector3d{across, down, -z - across * ray.x() - down * ray.y()}.normalized();
  // A slide moves the skin over the image by `slide_px`. The depth on a fixed ray then changes by the slope of the
  // skin.
  const Eigen::Vector2d slide_px = -rest_->pixels_per_m().cwiseProduct(pose_.slide_m_per_s);
  const double z_dt = -pose_.breath.speed_m_per_s * share.value - rise.per_s - du * slide_px.x() - dv * slide_px.y();
  const Eigen::Vector3d along_u = z_du * ray + z / camera.fx * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d along_v = dv * ray + z / camera.fy * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d velocity = z_dt * ray + along_u * slide_px.x() + along_v * slide_px.y();
  return {.at = {ray * z},
          .normal = {normal},
          .velocity_m_per_s = {velocity},
          .normal_velocity_m_per_s = velocity.dot(normal),
          .on_body = true};
}

bool TrueSurface::meets_body(double u, double v) const noexcept {
  const Eigen::Vector2d still = rest_->at_rest(u, v, pose_.slide_m);
  return rest_->meets_body(still.x(), still.y());
}

TrueSurfacePoint TrueSurface::at_pixel(double u, double v) const noexcept { return on_layer(u, v, meets_body(u, v)); }

TrueSurfacePoint TrueSurface::on_ray_through(const Point<DepthCamera>& point) const noexcept {
  const Pixel pixel = project(rest_->camera, point.m);
  return at_pixel(pixel.u, pixel.v);
}

std::optional<TrueSurfacePoint> TrueSurface::at_xy(double x_m, double y_m) const noexcept {
  // Newton's method on z: intersects the tangent plane at the ray's surface point with the parallel to the optical axis
  // through (x, y).
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
  const bool body = meets_body(first.u, first.v);
  TrueSurfacePoint foot = on_layer(first.u, first.v, body);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Eigen::Vector3d from_foot = point.m - foot.at.m;
    const Eigen::Vector3d along_tangent = from_foot - from_foot.dot(foot.normal.v) * foot.normal.v;
    if (along_tangent.norm() < 1e-8) return foot;
    const Eigen::Vector3d next = foot.at.m + along_tangent;
    if (next.z() < 0.1 * rest_->view_depth_m) return std::nullopt;
    const Pixel pixel = project(rest_->camera, next);
    foot = on_layer(pixel.u, pixel.v, body);
    if (body && !meets_body(pixel.u, pixel.v)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<TrueHeight> TrueSurface::height_along(const Point<DepthCamera>& point,
                                                    const Vector<DepthCamera>& up) const noexcept {
  double height_m = 0.0;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Eigen::Vector3d at = point.m + height_m * up.v;
    if (at.z() < 0.1 * rest_->view_depth_m) return std::nullopt;
    const TrueSurfacePoint hit = on_ray_through({at});
    const double facing = hit.normal.v.dot(up.v);
    if (std::abs(facing) < 0.05) return std::nullopt;
    const double off_m = (hit.at.m - at).dot(hit.normal.v) / facing;
    if (std::abs(off_m) < 1e-9) return TrueHeight{.m = height_m, .m_per_s = hit.normal_velocity_m_per_s / facing};
    height_m += off_m;
  }
  return std::nullopt;
}

std::optional<double> TrueSurface::signed_distance_m(const Point<DepthCamera>& point) const noexcept {
  const std::optional<TrueSurfacePoint> foot = closest_to(point);
  if (!foot) return std::nullopt;
  return (point.m - foot->at.m).dot(foot->normal.v);
}

}  // namespace telepalp::capture
