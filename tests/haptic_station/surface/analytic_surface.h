#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "proto/words/rgbd_frame.h"

namespace telepalp::testing {

/// The nearest surface point, exactly.
struct TrueFoot {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, out of the body
  double distance_m = 0.0;                           ///< signed, negative in the body
};

/// A surface known by formula, in the depth camera's frame (camera at the origin, looking along +z, body behind).
class AnalyticSurface {
 public:
  virtual ~AnalyticSurface() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// z of the first surface point on the ray through (x, y, 1)·z; 0 if the ray misses the surface.
  [[nodiscard]] virtual double depth_along(double x_per_z, double y_per_z) const = 0;
  [[nodiscard]] virtual TrueFoot foot(const Eigen::Vector3d& query) const = 0;
};

/// n·x = d with the camera outside.
[[nodiscard]] std::unique_ptr<AnalyticSurface> plane(const Eigen::Vector3d& at, const Eigen::Vector3d& normal);
[[nodiscard]] std::unique_ptr<AnalyticSurface> sphere(const Eigen::Vector3d& centre, double radius_m);
/// Ring radius and tube radius; axis along the camera's z.
[[nodiscard]] std::unique_ptr<AnalyticSurface> torus(const Eigen::Vector3d& centre, double ring_m, double tube_m);
/// z = z0 − bend/2 (x² − y²): radii 1/bend.
[[nodiscard]] std::unique_ptr<AnalyticSurface> saddle(double z0_m, double bend_per_m);
/// z = z0 − height·exp(−(x²+y²)/(2 width²)).
[[nodiscard]] std::unique_ptr<AnalyticSurface> gaussian_bump(double z0_m, double height_m, double width_m);
/// A valley: z = z0 − |x|·slope, the camera above it (concave where x = 0).
[[nodiscard]] std::unique_ptr<AnalyticSurface> crease(double z0_m, double slope);

/// A camera of 640×480 whose pixels are `spacing_m` apart at depth `z_m`.
[[nodiscard]] Intrinsics camera_with_spacing(double z_m, double spacing_m);
/// A Kinect-like camera with a focal length of 575 pixels.
[[nodiscard]] Intrinsics kinect_camera();

/// The sensor's error: Gaussian noise of `sigma_m` [m], seeded by frame.
struct RenderSettings {
  double unit_m = 2e-5;
  double sigma_m = 0.0;
  double hole_share = 0.0;
  std::uint64_t seed = 1;
};
[[nodiscard]] DepthImage render(const AnalyticSurface& surface, const Intrinsics& camera,
                                const RenderSettings& settings);

/// Adds noise and holes to a rendered image.
[[nodiscard]] DepthImage with_noise(const DepthImage& clean, const RenderSettings& settings);

}  // namespace telepalp::testing
