#pragma once

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "server/capture/synthetic/shape/image_field.h"
#include "server/capture/synthetic/shape/mesh.h"

namespace telepalp::server {

/// The scene at full exhale, as depth along the rays of one camera: smooth by construction, with one depth per ray, and
/// as cheap to move as a multiplication. What the camera cannot see has no place in it.
struct RestShape {
  Intrinsics camera;
  ImageField body_depth_m;  ///< z of the skin; meaningful where the ray meets the body and a few pixels beyond
  ImageField body_cover;    ///< above 0.5 where the ray meets the body, below where it meets the table
  double table_depth_m = 0.0;
  double view_depth_m = 0.0;  ///< the depth at which the breath's extent is laid out, about that of the belly

  [[nodiscard]] bool meets_body(double u, double v) const noexcept { return body_cover.at(u, v).value > 0.5; }

  /// How much of the breath's lift reaches the ray through pixel (u, v): 1 at the belly, about 0.6 at the breastbone,
  /// fading to nothing at neck, arms and thighs. Smooth everywhere.
  [[nodiscard]] ImageField::Sample lift_share(double u, double v) const noexcept;

  /// 1 where cloth covers the body (from the hips down, not on the hands), 0 on bare skin, in between along the hem.
  [[nodiscard]] double cloth_share(double u, double v) const noexcept;

  /// Where the ray through pixel (u, v) lies at the belly's depth [m]: towards the patient's head and right side.
  [[nodiscard]] Eigen::Vector2d body_coordinates_m(double u, double v) const noexcept;

  /// Pixels by which the image moves when the body slides by a metre, towards smaller u and v.
  [[nodiscard]] Eigen::Vector2d pixels_per_m() const noexcept {
    return {camera.fx / view_depth_m, camera.fy / view_depth_m};
  }

  /// The pixel at which the skin that pixel (u, v) sees lay before the body slid by `slide_m`.
  [[nodiscard]] Eigen::Vector2d at_rest(double u, double v, const Eigen::Vector2d& slide_m) const noexcept {
    return Eigen::Vector2d{u, v} + pixels_per_m().cwiseProduct(slide_m);
  }
};

/// Lays the patient of `mesh` (metres, y towards the head, +z front) on a table under the camera, head at the image's
/// left: the middle of the mesh below the pinhole, its highest point `camera_above_body_m` away. `where` names the mesh
/// in errors. The mesh's facets are rounded off by a Gaussian of 5 mm; the cloth rounds off more.
[[nodiscard]] Result<RestShape> lay_under_camera(const TriangleMesh& mesh, const Intrinsics& camera,
                                                 double camera_above_body_m, const std::string& where);

}  // namespace telepalp::server
