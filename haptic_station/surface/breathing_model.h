#pragma once

#include <Eigen/Core>
#include <array>
#include <deque>

namespace telepalp::surface {

/// 1, cos p, sin p, cos 2p, sin 2p of the breath's phase p: two harmonics carry a breath that rests at exhale.
using BreathTerms = Eigen::Matrix<double, 5, 1>;

/// The breath's phase and rate as one signal shows them, found in the last seconds of it and kept locked.
/// Locks on after about one and a half breaths; lets go within a quarter of a second when the signal no longer follows,
/// as when the patient holds the breath, speaks or coughs.
class BreathingModel {
 public:
  /// `displacement_m`: of the body's moving part, mean, along the rays, at steps of `dt_s`.
  void add(double displacement_m, double dt_s);

  [[nodiscard]] double rad_per_s() const noexcept { return rad_per_s_; }
  [[nodiscard]] double phase_rad() const noexcept { return phase_rad_; }
  /// How much the model is to be believed: 0 not locked, 1 locked; it changes smoothly.
  [[nodiscard]] double confidence() const noexcept { return confidence_; }
  [[nodiscard]] BreathTerms terms() const noexcept;

 private:
  struct Moment {
    double at_s = 0.0;
    double displacement_m = 0.0;
  };
  struct Fit {
    double rad_per_s = 0.0;
    double unexplained = 1.0;  ///< share of the signal's variance
    double amplitude_m = 0.0;
    BreathTerms coefficients = BreathTerms::Zero();
  };

  [[nodiscard]] Fit fit_at(double rad_per_s) const;
  void search();
  [[nodiscard]] bool follows(double displacement_m) const noexcept;

  std::deque<Moment> recent_;
  double now_s_ = 0.0;
  double since_kept_s_ = 1.0;
  int frames_to_search_ = 0;
  Fit fit_;
  double fitted_at_s_ = 0.0;
  double fitted_phase_rad_ = 0.0;
  double rad_per_s_ = 0.0;
  double phase_rad_ = 0.0;
  double confidence_ = 0.0;
  double misses_s_ = 0.0;
};

}  // namespace telepalp::surface
