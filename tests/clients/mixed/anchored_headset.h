#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "clients/mixed/anchor/headset_anchor.h"

namespace telepalp::mixed {

/// Errors of what an anchored headset shows: root mean squares over all arrangements.
struct AnchorError {
  double at_m = 0.0;  ///< of a point 10 cm from the middle of the triangle of touched places
  double turn_rad = 0.0;
};

/// Three places, `side_m` from each other, each touched `repeats` times with 1 mm of noise an axis, over `seeds`
/// arrangements of headset and device.
[[nodiscard]] inline AnchorError anchor_error(double side_m, int repeats, Gravity gravity, int seeds) {
  double squares = 0.0, turns = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    std::normal_distribution<double> normal;
    const auto vector = [&] {
      const double x = normal(random), y = normal(random), z = normal(random);
      return Eigen::Vector3d(x, y, z);
    };
    Eigen::Isometry3d truth =
        Eigen::Translation3d(vector()) * Eigen::AngleAxisd(3.0 * normal(random), Eigen::Vector3d::UnitY());
    std::vector<Touch> touches;
    for (int place = 0; place < 3; ++place) {
      const double at = 2.0943951 * place;
      const Eigen::Vector3d known = side_m / std::sqrt(3.0) * Eigen::Vector3d(std::cos(at), 0.1, std::sin(at));
      for (int i = 0; i < repeats; ++i) touches.push_back({place, {known}, {truth * known + 1e-3 * vector()}});
    }
    const Result<HeadsetAnchor> anchor = anchor_headset(touches, gravity);
    if (!anchor) return {1.0, 1.0};
    const Eigen::Isometry3d error = truth.inverse() * anchor->headset_from_haptic.iso;
    const Eigen::Vector3d target = 0.1 * vector().normalized();
    squares += (error * target - target).squaredNorm() / seeds;
    turns += std::pow(Eigen::AngleAxisd(error.linear()).angle(), 2) / seeds;
  }
  return {std::sqrt(squares), std::sqrt(turns)};
}

}  // namespace telepalp::mixed
