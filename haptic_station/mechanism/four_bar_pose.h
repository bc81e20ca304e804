#pragma once

#include <cmath>

#include "haptic_station/mechanism/four_bar.h"

namespace telepalp::mechanism {

/// A point or vector in the linkage's plane. `Number` is double, or a dual number that carries a derivative.
template <class Number>
struct InPlane {
  Number x{};
  Number y{};
};

template <class N>
[[nodiscard]] constexpr InPlane<N> operator+(const InPlane<N>& a, const InPlane<N>& b) noexcept {
  return {a.x + b.x, a.y + b.y};
}
template <class N>
[[nodiscard]] constexpr InPlane<N> operator-(const InPlane<N>& a, const InPlane<N>& b) noexcept {
  return {a.x - b.x, a.y - b.y};
}
template <class N>
[[nodiscard]] constexpr InPlane<N> operator*(const N& by, const InPlane<N>& a) noexcept {
  return {by * a.x, by * a.y};
}
template <class N>
[[nodiscard]] constexpr N dot(const InPlane<N>& a, const InPlane<N>& b) noexcept {
  return a.x * b.x + a.y * b.y;
}
/// `a`, turned counter-clockwise by a right angle.
template <class N>
[[nodiscard]] constexpr InPlane<N> left_of(const InPlane<N>& a) noexcept {
  return {-a.y, a.x};
}

/// The joints of S4's Figures 5 and 6 in the linkage's frame [m].
template <class Number>
struct FourBarPose {
  InPlane<Number> b;     ///< joint of links 2 and 3
  InPlane<Number> p;     ///< joint of links 1 and 2, where the needle begins
  InPlane<Number> d;     ///< where the handle begins on link 3
  InPlane<Number> c;     ///< end of the handle
  InPlane<Number> tip;   ///< tip of the needle
  InPlane<Number> axis;  ///< unit vector along the needle to its tip
};

/// Joint P lies where the circle of radius `l1_m` about A = 0 meets the circle of radius `l2_m` about `b`. It is the
/// vector AB times `along`, plus or minus the vector to the left of AB times `across`.
struct Closing {
  double along = 0.0;
  double across_squared = 0.0;  ///< square of `across`: 0 at a dead point, negative where the loop cannot close
};
[[nodiscard]] inline Closing closing(const FourBar& bar, const InPlane<double>& b) noexcept {
  const double squared = dot(b, b);
  const double along = (bar.l1_m * bar.l1_m - bar.l2_m * bar.l2_m + squared) / (2.0 * squared);
  return {along, bar.l1_m * bar.l1_m / squared - along * along};
}

/// The pose while link 3 has the angle `link3_rad`. `side`: +1 if P is left of the vector AB (the open branch), -1 if
/// it is right of it. B must not be at A. The order is that of S4 4.1: link 3, then D, then the handle, then links 1
/// and 2.
template <class Number>
[[nodiscard]] FourBarPose<Number> four_bar_pose(const FourBar& bar, const Number& link3_rad, double side) noexcept {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const InPlane<Number> link3{cos(link3_rad), sin(link3_rad)};
  const InPlane<Number> pivot_o{Number(bar.l4_m), Number(0.0)};
  FourBarPose<Number> pose;
  pose.b = pivot_o + Number(bar.l3_m) * link3;
  pose.d = pivot_o + Number(bar.handle_at_m) * link3;
  const Number handle_rad = link3_rad - Number(bar.handle_rad);
  pose.c = pose.d + Number(bar.handle_m) * InPlane<Number>{cos(handle_rad), sin(handle_rad)};
  const Number squared = dot(pose.b, pose.b);
  const Number along = (Number(bar.l1_m * bar.l1_m - bar.l2_m * bar.l2_m) + squared) / (Number(2.0) * squared);
  const Number across_squared = Number(bar.l1_m * bar.l1_m) / squared - along * along;
  const Number across = across_squared > Number(0.0) ? Number(side) * sqrt(across_squared) : Number(0.0);
  pose.p = along * pose.b + across * left_of(pose.b);
  const InPlane<Number> link2 = Number(1.0 / bar.l2_m) * (pose.p - pose.b);
  const double cosine = std::cos(bar.needle_rad);
  const double sine = std::sin(bar.needle_rad);
  pose.axis = Number(cosine) * link2 + Number(sine) * left_of(link2);
  pose.tip = pose.p + Number(bar.needle_m) * pose.axis;
  return pose;
}

/// The vector from O to the place where the hand holds the handle: its length, and its angle to link 3,
/// counter-clockwise. `held_share`: 0 where the handle begins (D), 1 at its end (C).
struct Lever {
  double length_m = 0.0;
  double from_link3_rad = 0.0;
};
[[nodiscard]] inline Lever lever_of(const FourBar& bar, double held_share = 1.0) noexcept {
  const double along_m = bar.handle_at_m + held_share * bar.handle_m * std::cos(bar.handle_rad);
  const double across_m = -held_share * bar.handle_m * std::sin(bar.handle_rad);
  return {std::hypot(along_m, across_m), std::atan2(across_m, along_m)};
}

}  // namespace telepalp::mechanism
