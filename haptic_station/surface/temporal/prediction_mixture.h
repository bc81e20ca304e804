#pragma once

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// What a frame predicts for its cells: their displacements at the capture, and their motion from then on.
struct FramePrediction {
  std::vector<float> displacement_m;  ///< since the start
  std::vector<MotionTerms> terms;
  MotionModel model;
};

/// Mean square errors of predictions [m²]: that the body stays where it is, that each cell moves on at its own velocity
/// (the straight term), that the body moves as modelled (the other terms), and their mixture.
struct PredictionErrors {
  double hold_m2 = 0.0;
  double straight_m2 = 0.0;
  double modelled_m2 = 0.0;
  double mixture_m2 = 0.0;
};

/// Weights of the straight and of the modelled prediction. The rest, up to 1, is the weight of holding.
struct PredictionWeights {
  double straight = 0.0;
  double modelled = 1.0;
};

/// The mixture: each of the three predictions is weighted by the inverse of its squared mean square error (forecasts
/// combined by their past errors: Bates and Granger 1969).
[[nodiscard]] PredictionWeights mixture_of(const PredictionErrors& lately) noexcept;

/// The choice between the modelled prediction, holding, and `mixture`, by the inverse 16th power of their mean square
/// errors. So the best one of the three has almost all of the weight, and the weights change continuously.
[[nodiscard]] PredictionWeights chosen(const PredictionErrors& over_long, const PredictionWeights& mixture) noexcept;

/// Weighs the predictions of the body's motion by their recent errors, so that none is much worse than holding. The
/// errors are those of earlier frames' predictions for the frame now measured, over all cells, for each of
/// kForesightAges_s. Two time scales in series: the mixture follows the errors of the last 0.3 s, so that a shift is
/// followed straight on; the choice follows those of the last 10 s, so that a patient who coughs, for whom no
/// prediction is right in time, is held. Owner: surface thread.
class PredictionMixture {
 public:
  /// Compares the predictions of earlier frames with the displacement now measured, by cell. `weight`: weight of each
  /// cell's error. Then remembers `now`, this frame's prediction.
  void add(std::span<const float> measured_m, std::span<const float> weight, FramePrediction now, double dt_s);

  [[nodiscard]] ForesightShare straight() const noexcept;
  [[nodiscard]] ForesightShare modelled() const noexcept;

 private:
  struct Past {
    double at_s;
    FramePrediction prediction;
    std::array<PredictionWeights, kForesightAges_s.size()> mixture;
  };
  struct Judge {
    PredictionErrors lately{};
    PredictionErrors over_long{};
    PredictionWeights mixture{};
    PredictionWeights chosen{};
  };

  void judge(std::size_t age, std::span<const float> measured_m, std::span<const float> weight, double dt_s);

  double now_s_ = 0.0;
  std::deque<Past> past_;
  std::array<Judge, kForesightAges_s.size()> judges_;
};

}  // namespace telepalp::surface
