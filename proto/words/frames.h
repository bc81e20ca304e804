#pragma once

#include <Eigen/Geometry>

namespace telepalp {

/// Frames of reference, each an empty tag type. All are right-handed, in metres.
///
/// DepthCamera (K)  origin at the depth sensor's pinhole; x right, y down in the image, z into the scene.
/// HandTracker (L)  origin at the tracker; axes as the maker defines them (Leap: x right, y away from it, z to user).
/// HapticBase  (H)  origin at the haptic device's base; y up, away from the patient; x and z span the plane
///                  above the body in which the end-effector waits (paper S1 in docs/sources.md, II.D).
/// Viewer      (V)  the viewpoint of the person who looks at the scene.
/// Body        (B)  fixed to the patient or the static model.
struct DepthCamera {};
struct HandTracker {};
struct HapticBase {};
struct Viewer {};
struct Body {};

/// A position in `Frame` [m].
template <class Frame>
struct Point {
  Eigen::Vector3d m = Eigen::Vector3d::Zero();
};

/// A free vector in `Frame`: a displacement [m], a velocity [m/s] or a unit direction; the variable's name tells which.
template <class Frame>
struct Vector {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
};

/// A force in `Frame` [N].
template <class Frame>
struct Force {
  Eigen::Vector3d N = Eigen::Vector3d::Zero();
};

template <class Frame>
[[nodiscard]] Vector<Frame> operator-(const Point<Frame>& to, const Point<Frame>& from) noexcept {
  return {to.m - from.m};
}
template <class Frame>
[[nodiscard]] Point<Frame> operator+(const Point<Frame>& from, const Vector<Frame>& by) noexcept {
  return {from.m + by.v};
}

/// A rigid motion named target-from-source: `haptic_from_camera * point_in_camera` is a point in the haptic base's
/// frame.
template <class To, class From>
struct Transform {
  Eigen::Isometry3d iso = Eigen::Isometry3d::Identity();

  Point<To> operator*(const Point<From>& point) const noexcept { return {iso * point.m}; }
  Vector<To> operator*(const Vector<From>& vector) const noexcept { return {iso.linear() * vector.v}; }
  Force<To> operator*(const Force<From>& force) const noexcept { return {iso.linear() * force.N}; }
  template <class Source>
  Transform<To, Source> operator*(const Transform<From, Source>& inner) const noexcept {
    return {iso * inner.iso};
  }
  [[nodiscard]] Transform<From, To> inverse() const noexcept { return {iso.inverse()}; }
};

}  // namespace telepalp
