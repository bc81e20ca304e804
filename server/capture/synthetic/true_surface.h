#pragma once

#include <memory>
#include <optional>

#include "proto/words/frames.h"
#include "server/capture/synthetic/motion/breathing.h"
#include "server/capture/synthetic/motion/patient_pose.h"
#include "server/capture/synthetic/shape/rest_shape.h"

namespace telepalp::server {

/// One point of the true surface and how it moves.
struct TrueSurfacePoint {
  Point<DepthCamera> at;
  Vector<DepthCamera> normal;            ///< unit, towards the camera's side: out of the body
  Vector<DepthCamera> velocity_m_per_s;  ///< of the material: breath and rise move it along its ray, a slide across
  double normal_velocity_m_per_s = 0.0;  ///< velocity along the normal: positive while the patient breathes in
  bool on_body = false;                  ///< skin; false: the table
};

/// Where a line meets the true surface, from a given point along the line, and how fast that moves.
struct TrueHeight {
  double m = 0.0;
  double m_per_s = 0.0;
};

/// What the camera would measure at one instant without noise, steps or holes: the skin, and beside it the table.
/// A value: cheap to copy (it shares the immutable shape at rest), safe from any thread.
///
/// Within a layer the surface is twice continuously differentiable in space and smooth in time. From skin to table it
/// steps, as depth does at a silhouette: a question is answered for the layer that the ray through the asked-for
/// point meets.
class TrueSurface {
 public:
  TrueSurface(std::shared_ptr<const RestShape> rest, const PatientPose& pose) noexcept;

  /// The point on the ray through pixel (u, v), any finite pixel coordinates, pixel centres at whole numbers.
  /// Error: none; this is the surface's definition. At a pixel centre its z is the noise-free depth to float rounding.
  [[nodiscard]] TrueSurfacePoint at_pixel(double u, double v) const noexcept;

  /// z [m] of the surface on the ray through pixel (u, v): at_pixel without the derivatives' cost to the reader.
  [[nodiscard]] double depth_m(double u, double v) const noexcept { return at_pixel(u, v).at.m.z(); }

  /// The point on the ray through `point`, for any point before the camera (z > 0).
  [[nodiscard]] TrueSurfacePoint on_ray_through(const Point<DepthCamera>& point) const noexcept;

  /// The point at camera coordinates (x, y) [m], parallel to the optical axis. nullopt where the search does not
  /// settle, which happens only within millimetres of a silhouette. Error: within 1e-9 m.
  [[nodiscard]] std::optional<TrueSurfacePoint> at_xy(double x_m, double y_m) const noexcept;

  /// The surface point nearest to `point`, which lies before the camera and within some 50 mm of the surface; found by
  /// following tangent planes from the ray through `point`, on that ray's layer. nullopt where this does not settle
  /// (near silhouettes). Error: within 1e-7 m.
  [[nodiscard]] std::optional<TrueSurfacePoint> closest_to(const Point<DepthCamera>& point) const noexcept;

  /// Height of the surface on the line through `point` along the unit vector `up`: `point + m * up` lies on it.
  /// nullopt where the search does not settle (near silhouettes, or a line that grazes the skin). Error: within 1e-8 m.
  [[nodiscard]] std::optional<TrueHeight> height_along(const Point<DepthCamera>& point,
                                                       const Vector<DepthCamera>& up) const noexcept;

  /// Distance from `point` to the nearest surface point [m]: positive outside, negative inside the body.
  [[nodiscard]] std::optional<double> signed_distance_m(const Point<DepthCamera>& point) const noexcept;

 private:
  [[nodiscard]] bool meets_body(double u, double v) const noexcept;
  [[nodiscard]] TrueSurfacePoint on_layer(double u, double v, bool body) const noexcept;

  std::shared_ptr<const RestShape> rest_;  // shared: every instant of a patient has the same shape at rest
  PatientPose pose_;
};

}  // namespace telepalp::server
