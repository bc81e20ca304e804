#pragma once

#include <Eigen/Core>

namespace telepalp::tissue {

/// The barycentric coordinates of the point of the triangle that is nearest to `p` (Ericson, Real-Time Collision
/// Detection, 5.1.5).
[[nodiscard]] inline Eigen::Vector3d nearest_shares(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c) noexcept {
  using Eigen::Vector3d;
  const Vector3d ab = b - a;
  const Vector3d ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6)); va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return {0.0, 1.0 - w, w};
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace telepalp::tissue
