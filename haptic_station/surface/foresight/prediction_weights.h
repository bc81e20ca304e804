#pragma once

#include <array>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// A value for each of three predictions of one motion.
using OfThree = std::array<double, 3>;
/// A value for each of the four predictions of PredictionWeights::weights().
using OfFour = std::array<double, 4>;

/// Weights with the sum 1, each proportional to (1 / mean square error of the prediction)^`power`. With the power 1 and
/// independent errors, the weighted mean of the predictions has the least variance (Bates and Granger 1969). A high
/// power comes close to the choice of the best prediction, but the weights stay continuous.
[[nodiscard]] OfThree inverse_power_weights(const OfThree& mean_square_m2, double power) noexcept;

/// Squared errors of the predictions for one instant, as means over the measured cells [m²].
struct SquareErrors {
  double own = 0.0;       ///< the station's own prediction, by the shared motion and the breathing model
  double holding = 0.0;   ///< prediction that nothing moves
  double straight = 0.0;  ///< prediction that each cell continues at its own velocity (StraightMotion)
  double mean = 0.0;      ///< mean of the three with the weights short_term() at the time of prediction
  double swing = 0.0;     ///< prediction by the shares that SwingRegression had learned
};

/// The weights of four predictions for the whole body at one age of the prediction, learned from their errors on two
/// time scales in series. First, the station's own prediction, holding, and the straight one are averaged with weights
/// from the errors of the last 0.3 s; this mean adapts while the patient shifts. Then the station's own prediction,
/// holding, this mean, and the swing about the mean place are averaged with weights from the errors of the last ten
/// seconds. A cough ends before the short scale has adapted; from earlier coughs, the long scale learns that holding
/// errs least. While the patient talks, it learns that the skin swings about its mean place (SwingRegression).
class PredictionWeights {
 public:
  /// Adds the errors of the predictions for this instant, weighted by `dt_s`, the time since the last frame.
  void add(const SquareErrors& errors, double dt_s) noexcept;
  /// Reduces the weight of earlier errors by the age `dt_s`. Call once per frame, before add(), also without an add().
  void pass(double dt_s) noexcept;

  /// Weights of own, holding and straight in the first mean.
  [[nodiscard]] OfThree short_term() const noexcept;
  /// Weights of own, holding, straight and swing, in both means together.
  [[nodiscard]] OfFour weights() const noexcept;

 private:
  OfThree lately_m2_s_{};  ///< own, holding, straight: sums with a decay over 0.3 s
  OfFour long_m2_s_{};     ///< own, holding, mean, swing: sums with a decay over ten seconds
  double prior_ = 1.0;     ///< weight of the prior that the station's own prediction is best
};

}  // namespace telepalp::surface
