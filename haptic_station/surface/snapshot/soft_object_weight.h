#pragma once

namespace telepalp::surface {

/// A weight and its derivative by `s`, the squared distance over the squared support.
struct Weight {
  double value = 0.0;
  double slope = 0.0;
};

/// The soft-object polynomial C(r) of Wyvill, McPheeters and Wyvill (1986), written in s = r²/R², with the distance r
/// and the support R: 1 at the centre, 0 with zero slope at r = R, 0 beyond. A sum of these weights is therefore
/// continuously differentiable (C1).
[[nodiscard]] inline Weight soft_object_weight(double s) noexcept {
  if (s >= 1.0) return {};
  constexpr double kCubic = -4.0 / 9.0;
  constexpr double kSquare = 17.0 / 9.0;
  constexpr double kLinear = -22.0 / 9.0;
  return {1.0 + s * (kLinear + s * (kSquare + s * kCubic)), kLinear + s * (2.0 * kSquare + s * 3.0 * kCubic)};
}

/// 1 up to s = 1/4 (half the support), then a continuously differentiable fade to 0 at s = 1. It serves as a factor
/// that must not change the weight of points well inside the support.
[[nodiscard]] inline Weight flat_top_weight(double s) noexcept {
  if (s <= 0.25) return {1.0, 0.0};
  if (s >= 1.0) return {};
  const double t = (s - 0.25) / 0.75;
  return {1.0 - t * t * (3.0 - 2.0 * t), -6.0 * t * (1.0 - t) / 0.75};
}

}  // namespace telepalp::surface
