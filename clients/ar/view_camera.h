#pragma once

#include <Eigen/Core>

namespace telepalp::ar {

/// A vertex projected to the image [px; pixel centres at n + 0.5], and its depth in the z-buffer (smaller is nearer).
struct Projected {
  float x = 0.0F;
  float y = 0.0F;
  float depth = 0.0F;
  bool visible = false;  ///< beyond the near plane, which is 0.02 m from the eye
};

/// The pinhole camera of the rendered view. All vectors are in the depth camera's frame.
struct ViewCamera {
  Eigen::Vector3f eye;
  Eigen::Matrix3f view_from_scene;  ///< rows: right, down, forward
  float focal_px = 1.0F;
  int width_px = 0;
  int height_px = 0;

  [[nodiscard]] Projected project(const Eigen::Vector3f& at) const noexcept;
};

/// A camera at `eye` that looks at `target`, with `up` vertical in the image. `height_rad`: vertical field of view.
[[nodiscard]] ViewCamera look_at(const Eigen::Vector3f& eye, const Eigen::Vector3f& target, const Eigen::Vector3f& up,
                                 float height_rad, int width_px, int height_px);

}  // namespace telepalp::ar
