#pragma once

#include <memory>
#include <optional>

#include "proto/words/frames.h"
#include "server/capture/synthetic/motion/breathing.h"
#include "server/capture/synthetic/motion/patient_pose.h"
#include "server/capture/synthetic/shape/rest_shape.h"

namespace telepalp::capture {

/// One point of the true surface with its velocity. Breathing and rising of the body move the skin along the camera's
/// ray through the point, sliding moves it across this ray.
struct TrueSurfacePoint {
  Point<DepthCamera> at;
  Vector<DepthCamera> normal;            ///< unit, out of the body, towards the camera
  Vector<DepthCamera> velocity_m_per_s;  ///< of the skin at `at`; zero on the table
  double normal_velocity_m_per_s = 0.0;  ///< velocity along `normal`; positive: out of the body
  bool on_body = false;                  ///< skin; false: the table
};

/// Distance along a line from a given point to the true surface, with its rate of change.
struct TrueHeight {
  double m = 0.0;
  double m_per_s = 0.0;
};

/// The surface that an ideal camera would measure at one instant, without noise, quantisation or holes: the skin, and
/// the table beside it. A value type: cheap to copy (copies share the immutable shape at rest) and usable from any
/// thread.
///
/// Each of the two layers, skin and table, is twice continuously differentiable in space and smooth in time. At a
/// silhouette, depth steps from one layer to the other; a query uses the layer that the ray through the query point
/// meets.
class TrueSurface {
 public:
  TrueSurface(std::shared_ptr<const RestShape> rest, const PatientPose& pose) noexcept;

  /// The surface point on the ray through pixel (u, v), for any finite coordinates; pixel centres have integer
  /// coordinates. Exact, since this function defines the surface. At a pixel centre, z equals the depth of the
  /// noise-free depth image up to float rounding.
  [[nodiscard]] TrueSurfacePoint at_pixel(double u, double v) const noexcept;

  /// Depth z [m] of the surface on the ray through pixel (u, v).
  [[nodiscard]] double depth_m(double u, double v) const noexcept { return at_pixel(u, v).at.m.z(); }

  /// The surface point on the ray through `point`, for any point in front of the camera (z > 0).
  [[nodiscard]] TrueSurfacePoint on_ray_through(const Point<DepthCamera>& point) const noexcept;

  /// The surface point with the camera coordinates (x, y) [m]. nullopt where the search does not converge, which
  /// happens only within millimetres of a silhouette. Numerical error: at most 1e-9 m.
  [[nodiscard]] std::optional<TrueSurfacePoint> at_xy(double x_m, double y_m) const noexcept;

  /// The surface point nearest to `point`, which lies in front of the camera and within about 50 mm of the surface. The
  /// search begins where the ray through `point` meets the surface, stays on that layer and steps along tangent planes.
  /// nullopt where the search does not converge (near silhouettes). Numerical error: at most 1e-7 m.
  [[nodiscard]] std::optional<TrueSurfacePoint> closest_to(const Point<DepthCamera>& point) const noexcept;

  /// Height of the surface on the line through `point` along the unit vector `up`: `point + m * up` lies on the
  /// surface. nullopt where the search does not converge (near silhouettes, or on a line that grazes the skin).
  /// Numerical error: at most 1e-8 m.
  [[nodiscard]] std::optional<TrueHeight> height_along(const Point<DepthCamera>& point,
                                                       const Vector<DepthCamera>& up) const noexcept;

  /// Distance from `point` to closest_to(point) [m]: positive outside, negative inside the body. nullopt where
  /// closest_to() returns nullopt.
  [[nodiscard]] std::optional<double> signed_distance_m(const Point<DepthCamera>& point) const noexcept;

 private:
  [[nodiscard]] bool meets_body(double u, double v) const noexcept;
  [[nodiscard]] TrueSurfacePoint on_layer(double u, double v, bool body) const noexcept;

  std::shared_ptr<const RestShape> rest_;  // shared by all TrueSurfaces of a patient
  PatientPose pose_;
};

}  // namespace telepalp::capture
