#pragma once

#include "haptic_station/mechanism/planar_mechanism.h"

namespace telepalp::mechanism {

/// Where a point of a body is in the frame's axes [m].
[[nodiscard]] Eigen::Vector2d place_of(const BodyPoint& point, const PlanarPose& pose) noexcept;

/// Derivative of place_of() by all coordinates: 2 rows.
[[nodiscard]] Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMostCoordinates> motion_of(
    const BodyPoint& point, const PlanarPose& pose) noexcept;

/// The joints' equations: errors [m], which are 0 where all joints are closed, and their derivatives.
struct JointEquations {
  PlanarErrors errors;
  PlanarRows rows;
};
[[nodiscard]] JointEquations joint_equations(const PlanarMechanism& mechanism, const PlanarPose& pose) noexcept;

/// All solutions of rows * x = -errors: one of them, and a basis of those of rows * x = 0.
struct Solutions {
  PlanarPose one;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostCoordinates, kMostCoordinates> free;
};
/// By Gauss-Jordan elimination with full pivoting. Rows whose pivot is below 1e-9 of the largest one are dependent.
[[nodiscard]] Solutions solutions_of(const JointEquations& equations) noexcept;

}  // namespace telepalp::mechanism
