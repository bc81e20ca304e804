#pragma once

#include <Eigen/Core>
#include <cmath>

namespace telepalp::tissue {

/// A soft body around a tool, to first order: a plane that pushes the tool out with stiffness × depth, without
/// friction, so that the stiffness matrix is stiffness × normal × normal^T. The slow computation makes it 60 times a
/// second, and the haptic thread evaluates it in each tick. Frame: H.
struct LocalPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< out of the body, unit length; zero: no body is near
  double offset_m = 0.0;                             ///< normal · x where the force is zero
  double stiffness_N_per_m = 0.0;
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();  ///< the contact point, or the nearest point of the body
  bool in_contact = false;

  [[nodiscard]] double depth_m(const Eigen::Vector3d& tool_m) const noexcept { return offset_m - normal.dot(tool_m); }
  [[nodiscard]] double force_N(const Eigen::Vector3d& tool_m) const noexcept {
    return stiffness_N_per_m * std::fmax(0.0, depth_m(tool_m));
  }
  [[nodiscard]] bool usable() const noexcept {
    return normal.allFinite() && std::isfinite(offset_m) && at_m.allFinite() && stiffness_N_per_m > 0.0 &&
           std::isfinite(stiffness_N_per_m) && std::abs(normal.squaredNorm() - 1.0) < 1e-6;
  }
};

}  // namespace telepalp::tissue
