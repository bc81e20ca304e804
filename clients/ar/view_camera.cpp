#include "clients/ar/view_camera.h"

#include <Eigen/Geometry>
#include <cmath>

namespace telepalp::ar {

Projected ViewCamera::project(const Eigen::Vector3f& at) const noexcept {
  constexpr float kNear_m = 0.02F;
  const Eigen::Vector3f seen = view_from_scene * (at - eye);
  if (!(seen.z() > kNear_m)) return {};
  // -1/z is linear on the image and grows with distance, as the z-buffer needs it.
  return {0.5F * static_cast<float>(width_px) + focal_px * seen.x() / seen.z(),
          0.5F * static_cast<float>(height_px) + focal_px * seen.y() / seen.z(), -1.0F / seen.z(), true};
}

ViewCamera look_at(const Eigen::Vector3f& eye, const Eigen::Vector3f& target, const Eigen::Vector3f& up,
                   float height_rad, int width_px, int height_px) {
  const Eigen::Vector3f forward = (target - eye).normalized();
  const Eigen::Vector3f right = forward.cross(up).normalized();
  ViewCamera camera;
  camera.eye = eye;
  camera.view_from_scene.row(0) = right.transpose();
  camera.view_from_scene.row(1) = forward.cross(right).transpose();
  camera.view_from_scene.row(2) = forward.transpose();
  camera.focal_px = 0.5F * static_cast<float>(height_px) / std::tan(0.5F * height_rad);
  camera.width_px = width_px;
  camera.height_px = height_px;
  return camera;
}

}  // namespace telepalp::ar
