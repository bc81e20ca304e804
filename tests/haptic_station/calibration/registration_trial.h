#pragma once

#include <algorithm>
#include <vector>

#include "haptic_station/calibration/point_registration.h"
#include "haptic_station/device/random.h"

namespace telepalp::calibration {

/// Standard deviation per axis. The length of such an error has a Maxwell distribution with mean 1.35 mm and deviation
/// 0.57 mm, as S3 4.2 measured.
inline constexpr double kPaperNoise_m = 0.846e-3;

/// People click `places` in a box of 0.30 x 0.20 x 0.25 m, each `repeats` times, with `noise_m` by axis.
struct RegistrationTrial {
  int places = 8;
  int repeats = 3;
  double noise_m = kPaperNoise_m;
};

inline Eigen::Vector3d in_box(device::Random& random) {
  return {random.uniform(-0.15, 0.15), random.uniform(-0.10, 0.10), random.uniform(-0.125, 0.125)};
}

inline Eigen::Vector3d normal(device::Random& random) { return {random.normal(), random.normal(), random.normal()}; }

struct MadePairs {
  Eigen::Isometry3d truth;
  std::vector<PointPair> pairs;
};

inline MadePairs make_pairs(const RegistrationTrial& trial, device::Random& random) {
  const Eigen::Vector3d axis = normal(random).normalized();
  MadePairs made{.truth = Eigen::Translation3d(normal(random) * 0.3) * Eigen::AngleAxisd(random.uniform(0, 3.1), axis),
                 .pairs = {}};
  for (int place = 0; place < trial.places; ++place) {
    // The first eight are the box's corners, as a person would choose them.
    Eigen::Vector3d from = in_box(random);
    if (place < 8) from = {place & 1 ? 0.15 : -0.15, place & 2 ? 0.10 : -0.10, place & 4 ? 0.125 : -0.125};
    for (int i = 0; i < trial.repeats; ++i)
      made.pairs.push_back({place, made.truth * from + normal(random) * trial.noise_m, from});
  }
  return made;
}

struct TrialErrors {
  Residuals at_targets;  ///< errors of the calibrated motion at points that were not clicked: the error of co-location
  Residuals residuals;   ///< distances of the clicks from the fit, as S3 reports
  Residuals noise;       ///< distances of the clicks from the truth
};

/// `runs` calibrations, each with its own motion, places and noise.
inline TrialErrors registration_errors(const RegistrationTrial& trial, RotationBy by, int runs, std::uint64_t seed) {
  device::Random random(seed);
  TrialErrors errors;
  for (int run = 0; run < runs; ++run) {
    const MadePairs made = make_pairs(trial, random);
    const Result<Registration> fit = register_points(made.pairs, {.rotation_by = by});
    demand(fit.ok(), "a trial can be calibrated");
    for (int i = 0; i < 10; ++i) {
      const Eigen::Vector3d target = in_box(random);
      errors.at_targets.each_m.push_back((fit->to_from_from * target - made.truth * target).norm());
    }
    for (const PointPair& pair : made.pairs) errors.noise.each_m.push_back((made.truth * pair.from - pair.to).norm());
    std::copy(fit->residuals.each_m.begin(), fit->residuals.each_m.end(), std::back_inserter(errors.residuals.each_m));
  }
  return errors;
}

}  // namespace telepalp::calibration
