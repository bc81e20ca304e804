#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// 1, cos p, sin p, cos 2p, sin 2p of the breath's phase p, or their coefficients [m]. Two harmonics can represent a
/// breath with a rest after exhaling.
using BreathTerms = Eigen::Matrix<double, 5, 1>;

/// A periodic model of breathing, fitted to the motion of the image's cells (16 × 16 pixels each): one common rate, and
/// an amplitude and phase for each cell. At every sixth frame, the model is fitted by least squares to the last 12 s.
/// Its confidence rises after about one and a half breaths, and falls to 0 within a third of a second when the body no
/// longer follows the model, as when the patient holds the breath, speaks or coughs.
class BreathingModel {
 public:
  /// Adds a frame. `displacement_m`: change of each cell's depth since the first frame. `weight`: weight of each cell
  /// in the fit of the rate, larger for a cell that moves more. The number of cells is the same in every frame.
  void add(std::span<const float> displacement_m, std::span<const float> weight, double dt_s);

  [[nodiscard]] double rad_per_s() const noexcept { return fit_.rad_per_s; }
  /// Weight of the model's prediction, 0 (unused) to 1; it changes gradually.
  [[nodiscard]] double confidence() const noexcept { return confidence_; }
  /// The coefficients of a cell's predicted change of depth at the time τ from now: A (cos ωτ − 1) + B sin ωτ, plus two
  /// terms alike with 2ω. The first and the last coefficient of MotionTerms, those of motions linear in τ, are 0.
  [[nodiscard]] MotionTerms motion_of(std::size_t cell) const noexcept;

 private:
  struct Moment {
    double at_s = 0.0;
    std::vector<float> displacement_m;
  };
  struct Fit {
    double rad_per_s = 0.0;
    double unexplained = 1.0;  ///< share of the signal's variance that the fit does not explain
    double amplitude_m = 0.0;
    BreathTerms coefficients = BreathTerms::Zero();
  };

  void remember(std::span<const float> displacement_m);
  [[nodiscard]] Fit fit_at(const std::vector<double>& signal, double rad_per_s) const;
  [[nodiscard]] Fit best_fit(const std::vector<double>& signal) const;
  void refit(std::span<const float> weight);
  void fit_cells();
  [[nodiscard]] double signal_of(std::span<const float> displacement_m) const noexcept;
  [[nodiscard]] bool follows(double signal_m) const noexcept;

  std::deque<Moment> recent_;
  std::vector<float> weight_;  ///< weights of the last fit; their sum is 1
  std::vector<BreathTerms> cells_;
  double now_s_ = 0.0;
  double since_kept_s_ = 1.0;
  int frames_to_fit_ = 0;
  int steady_fits_ = 0;  ///< consecutive fits that agree on the rate
  Fit fit_;
  double fitted_at_s_ = 0.0;  ///< the instant at which the phase is 0
  double confidence_ = 0.0;
  double misses_s_ = 0.0;
};

}  // namespace telepalp::surface
