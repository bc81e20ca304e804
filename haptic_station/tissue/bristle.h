#pragma once

#include <algorithm>

#include "haptic_station/tissue/relaxing_spring.h"

namespace telepalp::tissue {

/// Dry friction as a bristle that bends, then slips: the elasto-plastic model of Dupont et al. 2002 (docs/sources.md).
/// Below 0.7 of the greatest force the bristle is a spring, so a needle at rest neither creeps nor drifts. Above, it
/// slips by a growing share of the motion, and at the greatest force by all of it. Its anchor only ever follows the
/// tip, so it gives back at most what it stores. At zero velocity the force is the bristle's own, in any direction.
///
/// The spring has relaxing branches (RelaxingSpring). A bristle that slips grips tissue that has not relaxed yet, so
/// slipping multiplies the extensions of all branches by the same factor. If slipping moved one common anchor instead,
/// the branches would relax to zero while the needle slides. The force of a needle that stops would then no longer
/// fall, but measured forces do.
class Bristle {
 public:
  /// Moves the tip by `by_m`. The friction force is at most `most_N`.
  void step(const Eigen::Vector3d& by_m, double stiffness_N_per_m, double most_N, const Relaxation& relaxation,
            double dt_s) noexcept {
    spring_.relax(relaxation, dt_s);
    const Eigen::Vector3d bent_m = spring_.extension_m(relaxation);
    const double longest_m = most_N / stiffness_N_per_m;
    const double along_m2 = bent_m.dot(by_m);
    spring_.move(by_m);
    if (along_m2 > 0.0 && longest_m > 0.0) {
      const double full = std::min(1.0, bent_m.norm() / longest_m);
      const double slipping = full * std::clamp((full - kElastic) / (1.0 - kElastic), 0.0, 1.0);
      hold((bent_m + by_m - slipping * along_m2 / bent_m.squaredNorm() * bent_m).norm(), relaxation);
    }
    hold(longest_m, relaxation);
  }
  /// Shortens the bristle to at most `longest_m`.
  void hold(double longest_m, const Relaxation& relaxation) noexcept {
    const double length_m = spring_.extension_m(relaxation).norm();
    if (length_m > longest_m) spring_.shorten(longest_m / length_m);
  }
  void shorten(double share) noexcept { spring_.shorten(share); }
  [[nodiscard]] Eigen::Vector3d bent_m(const Relaxation& relaxation) const noexcept {
    return spring_.extension_m(relaxation);
  }
  [[nodiscard]] double stored_m2(const Relaxation& relaxation) const noexcept { return spring_.stored_m2(relaxation); }

 private:
  static constexpr double kElastic = 0.7;  ///< share of the greatest force up to which nothing slips: z_ba / z_max
  RelaxingSpring spring_;
};

}  // namespace telepalp::tissue
