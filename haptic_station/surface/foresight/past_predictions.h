#pragma once

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "haptic_station/surface/foresight/prediction_weights.h"
#include "haptic_station/surface/foresight/swing_regression.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// Compares each frame with the predictions that earlier frames made for it, and learns from their errors the weights
/// of the predictions in SquareErrors, for the whole body, at each of kForesightAges_s. Owner: surface thread.
class PastPredictions {
 public:
  /// Judges the predictions for the frame that has just been measured, `dt_s` after the last one. `measured_m`: change
  /// of each cell's depth since the first frame. `weight`: weight of each cell's error; 0: not measured.
  void judge(std::span<const float> measured_m, std::span<const float> weight, double dt_s);
  /// Remembers this frame's predictions: the change of each cell's depth since the first frame, and the terms of its
  /// motion. `own`, `straight` and `to_mean` in `model` are ignored, because each prediction is judged alone.
  void remember(std::span<const float> displacement_m, std::span<const MotionTerms> terms, const MotionModel& model);

  [[nodiscard]] ForesightShare own() const noexcept { return weights_of(0); }
  [[nodiscard]] ForesightShare straight() const noexcept;
  [[nodiscard]] ForesightShare to_mean() const noexcept;

 private:
  struct Past {
    double at_s;
    std::vector<float> displacement_m;
    std::vector<MotionTerms> terms;
    MotionModel model;
    std::array<OfThree, kForesightAges_s.size()> mean;  ///< PredictionWeights::short_term()
    std::array<SwingRegression::Shares, kForesightAges_s.size()> swings;
  };

  void judge_past(const Past& then, std::size_t age, std::span<const float> measured_m, std::span<const float> weight,
                  double dt_s) noexcept;
  [[nodiscard]] const Past* made_before(double age_s) const noexcept;
  [[nodiscard]] ForesightShare weights_of(std::size_t prediction) const noexcept;

  std::deque<Past> past_;
  std::array<PredictionWeights, kForesightAges_s.size()> by_age_;
  std::array<SwingRegression, kForesightAges_s.size()> swing_;
  double now_s_ = 0.0;
};

}  // namespace telepalp::surface
