#include "server/capture/synthetic/shape/rest_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "proto/words/smooth_step.h"
#include "server/capture/synthetic/shape/rasterise.h"
#include "server/capture/synthetic/shape/smooth.h"

namespace telepalp::capture {
namespace {

constexpr double kSmoothing_m = 0.005;       // smooths facets of 13 mm and keeps the navel
constexpr double kClothSmoothing_m = 0.022;  // cloth spans the hollows of the body
constexpr double kHem_m = -0.225;            // along the body from the picture's middle, negative towards the feet
constexpr double kHips_m = 0.28;             // half width of the hips; the hands lie beyond
constexpr double kSilhouette_px = 1.2;       // smooths the steps of the mask
constexpr float kBodyAboveTable_m = 0.004F;  // skin nearer to the table than this counts as table
constexpr double kSmallestBody_m = 0.1;
constexpr double kLargestBody_m = 4.0;

Error unusable(const std::string& where, std::string what) {
  return {.what = std::move(what),
          .where = where,
          .fix = "give a mesh in metres, y towards the head, +z out of the patient's front"};
}

/// The mesh in the camera's frame: x = -y, y = -x, z = -z puts the front towards the pinhole, the head to the left.
TriangleMesh under_camera(const TriangleMesh& mesh, const Eigen::AlignedBox3f& box, double camera_above_body_m) {
  TriangleMesh placed = mesh;
  const Eigen::Vector3f middle = box.center();
  for (Eigen::Vector3f& p : placed.vertices)
    p = {middle.y() - p.y(), middle.x() - p.x(), static_cast<float>(camera_above_body_m) + box.max().z() - p.z()};
  return placed;
}

/// A bump of height 1 at (s0, t0) with widths (s, t), and its gradient [per m].
struct Bump {
  double value;
  Eigen::Vector2d gradient;
};
Bump bump(const Eigen::Vector2d& at, const Eigen::Vector2d& middle, const Eigen::Vector2d& width) noexcept {
  const Eigen::Vector2d scaled = (at - middle).cwiseQuotient(width);
  const double value = std::exp(-0.5 * scaled.squaredNorm());
  return {value, -value * scaled.cwiseQuotient(width)};
}

}  // namespace

Eigen::Vector2d RestShape::body_coordinates_m(double u, double v) const noexcept {
  return {-(u - camera.cx) / camera.fx * view_depth_m, -(v - camera.cy) / camera.fy * view_depth_m};
}

double RestShape::cloth_share(double u, double v) const noexcept {
  const Eigen::Vector2d at = body_coordinates_m(u, v);
  const double hem = kHem_m - 0.02 * std::cos(9.0 * at.y());
  return smooth_step(hem + 0.004, hem - 0.004, at.x()) * smooth_step(kHips_m, kHips_m - 0.02, std::abs(at.y()));
}

ImageField::Sample RestShape::lift_share(double u, double v) const noexcept {
  const Eigen::Vector2d at = body_coordinates_m(u, v);
  const Bump belly = bump(at, {-0.07, 0.0}, {0.085, 0.11});
  const Bump chest = bump(at, {0.14, 0.0}, {0.09, 0.12});
  const Eigen::Vector2d per_metre = belly.gradient + 0.55 * chest.gradient;
  return {.value = belly.value + 0.55 * chest.value,
          .du = -per_metre.x() * view_depth_m / camera.fx,
          .dv = -per_metre.y() * view_depth_m / camera.fy};
}

Result<RestShape> lay_under_camera(const TriangleMesh& mesh, const Intrinsics& camera, double camera_above_body_m,
                                   const std::string& where) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex);
  const double largest_m = box.isEmpty() ? 0.0 : static_cast<double>(box.sizes().maxCoeff());
  if (!(largest_m >= kSmallestBody_m && largest_m <= kLargestBody_m))
    return unusable(where, "is " + std::to_string(largest_m) + " m long; a patient is 0.1 to 4 m long");

  const TriangleMesh placed = under_camera(mesh, box, camera_above_body_m);
  const double table_depth_m = camera_above_body_m + static_cast<double>(box.sizes().z());
  std::vector<float> depth = rasterise(placed, camera);
  std::vector<float> mask(depth.size());
  for (std::size_t i = 0; i < depth.size(); ++i)
    mask[i] = depth[i] > 0.0F && depth[i] < static_cast<float>(table_depth_m) - kBodyAboveTable_m ? 1.0F : 0.0F;

  RestShape shape;
  shape.camera = camera;
  shape.table_depth_m = table_depth_m;
  shape.view_depth_m = camera_above_body_m + 0.03;
  const ImageSize size{camera.width, camera.height};
  const double sigma_px = kSmoothing_m * camera.fx / shape.view_depth_m;
  const double cloth_sigma_px = kClothSmoothing_m * camera.fx / shape.view_depth_m;
  const auto elsewhere = static_cast<float>(table_depth_m);
  std::vector<float> smooth = masked_blur(depth, mask, size, sigma_px, elsewhere);
  const std::vector<float> cloth = masked_blur(depth, mask, size, cloth_sigma_px, elsewhere);
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    const auto u = static_cast<double>(i % static_cast<std::size_t>(size.width));
    const auto v = static_cast<double>(i / static_cast<std::size_t>(size.width));
    smooth[i] += static_cast<float>(shape.cloth_share(u, v)) * (cloth[i] - smooth[i]);
  }
  shape.body_depth_m = ImageField{size.width, size.height, std::move(smooth)};
  shape.body_cover = ImageField{size.width, size.height, blur(std::move(mask), size, kSilhouette_px)};
  if (!shape.meets_body(camera.cx, camera.cy))
    return unusable(where, "has no surface in the middle of the camera's image");
  return shape;
}

}  // namespace telepalp::capture
