#pragma once

#include <algorithm>

#include "proto/words/frames.h"
#include "proto/words/wrench.h"

namespace telepalp::effects {

/// Sum of the magnitudes of some springs' forces, and its derivative by a depth that is added to all their depths.
struct Pull {
  double N = 0.0;
  double N_per_m = 0.0;
  Pull& operator+=(const Pull& other) noexcept {
    N += other.N;
    N_per_m += other.N_per_m;
    return *this;
  }
  Pull& operator-=(const Pull& other) noexcept { return *this += {-other.N, -other.N_per_m}; }
};

/// A spring of constant stiffness at one tick. Its force is stiffness × depth × `outwards`.
///
/// A relaxed spring acts as if its depth were smaller by `relaxed_m`; it keeps its direction. EffectBank relaxes all
/// springs of a scene by one common depth while their forces sum to more than the device can give. The energy that such
/// a spring adds to EffectBank::energy_J() is that of the smaller depth, plus `relaxed_m` times its force.
struct LinearSpring {
  double stiffness_N_per_m = 0.0;
  double depth_m = 0.0;
  Eigen::Vector3d outwards = Eigen::Vector3d::Zero();  ///< minus the gradient of the depth; at most unit length

  [[nodiscard]] Pull pull(double relaxed_m) const noexcept {
    const double left_m = depth_m - relaxed_m;
    return left_m > 0.0 ? Pull{stiffness_N_per_m * left_m, stiffness_N_per_m} : Pull{};
  }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept { return {pull(relaxed_m).N * outwards}; }
  [[nodiscard]] double energy_J(double relaxed_m) const noexcept {
    const double left_m = std::max(0.0, depth_m - relaxed_m);
    return 0.5 * stiffness_N_per_m * left_m * (left_m + 2.0 * relaxed_m);
  }
};

/// A spring at one tick whose depth also depends on the tool's attitude, because it acts on a point beside the tool's
/// point. Its torque is its force's magnitude times `turning`.
///
/// Torque joins the common relaxation by `weight`, which is constant for each spring while a contact lasts: the spring
/// is relaxed by weight × the common depth, and its force counts weight times in the sum of magnitudes. With the
/// weights of lever_weight(), a sum of at most B bounds the force by B and the torque by T, the device's greatest
/// torque. The relaxed wrenches are still the gradient of one energy, with the constraint weight × p in place of p
/// (EffectBank).
struct LeverSpring {
  LinearSpring spring;
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();  ///< minus the depth's derivative by the tool's rotation [m/rad]
  double weight = 1.0;

  [[nodiscard]] Pull pull(double relaxed_m) const noexcept {
    const Pull own = spring.pull(weight * relaxed_m);
    return {weight * own.N, weight * weight * own.N_per_m};
  }
  [[nodiscard]] Wrench<HapticBase> wrench(double relaxed_m) const noexcept {
    const double magnitude_N = spring.pull(weight * relaxed_m).N;
    return {.force = {magnitude_N * spring.outwards}, .torque = {magnitude_N * turning}};
  }
  [[nodiscard]] double energy_J(double relaxed_m) const noexcept { return spring.energy_J(weight * relaxed_m); }
};

/// The weight of a spring whose `turning` is at most `lever_m` long, on a device whose greatest force is `N_per_N_m`
/// times its greatest torque [1/m]. A device without torque (0) shows the force alone.
[[nodiscard]] inline double lever_weight(double lever_m, double N_per_N_m) noexcept {
  return std::max(1.0, lever_m * N_per_N_m);
}

/// The common depth by which springs must be relaxed, so that the magnitudes of their forces sum to at most `most_N`; 0
/// if they need not be relaxed. `pull_at(relaxed_m)` gives their Pull. Newton's method from 0 on: no spring gets softer
/// with depth, so the sum is a convex, falling function of the relaxation, and no step goes too far. From a sum of 25 N
/// to 10 N it takes two to five iterations.
template <class PullAt>
[[nodiscard]] double common_relaxation_m(const PullAt& pull_at, double most_N) noexcept {
  constexpr int kMostRounds = 24;
  constexpr double kNear_N = 1e-9;
  double relaxed_m = 0.0;
  for (int i = 0; i < kMostRounds; ++i) {
    const Pull sum = pull_at(relaxed_m);
    if (!(sum.N > most_N + kNear_N)) break;
    relaxed_m += (sum.N - most_N) / sum.N_per_m;
  }
  return relaxed_m;
}

}  // namespace telepalp::effects
