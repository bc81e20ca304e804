#pragma once

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "server/capture/synthetic/shape/image_field.h"
#include "server/capture/synthetic/shape/mesh.h"

namespace telepalp::capture {

/// The scene at full exhale, as a smooth depth per camera ray. Breathing subtracts the breath's lift times lift_share()
/// from the depth of each ray. Surfaces that the camera cannot see are not represented.
struct RestShape {
  Intrinsics camera;
  ImageField body_depth_m;  ///< z of the skin; valid where the ray meets the body and a few pixels beyond
  ImageField body_cover;    ///< above 0.5 where the ray meets the body, below 0.5 at the table
  double table_depth_m = 0.0;
  double view_depth_m = 0.0;  ///< depth of the plane in which body coordinates are defined, about that of the belly

  [[nodiscard]] bool meets_body(double u, double v) const noexcept { return body_cover.at(u, v).value > 0.5; }

  /// Share of the breath's lift at pixel (u, v): 1 at the belly, about 0.6 at the breastbone, falling to 0 at neck,
  /// arms and thighs. Smooth everywhere.
  [[nodiscard]] ImageField::Sample lift_share(double u, double v) const noexcept;

  /// 1 where cloth covers the body (from the hips down, not on the hands), 0 on bare skin, between 0 and 1 along the
  /// hem.
  [[nodiscard]] double cloth_share(double u, double v) const noexcept;

  /// Body coordinates [m] of the ray through pixel (u, v) at depth view_depth_m: x towards the patient's head, y
  /// towards the patient's left, origin on the optical axis.
  [[nodiscard]] Eigen::Vector2d body_coordinates_m(double u, double v) const noexcept;

  /// Pixels of image motion per metre that the body slides in body coordinates. A positive slide moves the image
  /// towards smaller u and v.
  [[nodiscard]] Eigen::Vector2d pixels_per_m() const noexcept {
    return {camera.fx / view_depth_m, camera.fy / view_depth_m};
  }

  /// The skin point at pixel (u, v) was at the returned pixel before the body slid by `slide_m`.
  [[nodiscard]] Eigen::Vector2d at_rest(double u, double v, const Eigen::Vector2d& slide_m) const noexcept {
    return Eigen::Vector2d{u, v} + pixels_per_m().cwiseProduct(slide_m);
  }
};

/// Lays the patient of `mesh` (metres, y to the head, +z front) on a table: head at the image's left, mesh centred
/// under the pinhole, highest point at depth `camera_above_body_m`. Gaussian smoothing: sigma 5 mm, under cloth 22 mm.
/// `where`: the mesh's name, for errors. Error: not 0.1 to 4 m long, or no surface in the image's middle.
[[nodiscard]] Result<RestShape> lay_under_camera(const TriangleMesh& mesh, const Intrinsics& camera,
                                                 double camera_above_body_m, const std::string& where);

}  // namespace telepalp::capture
