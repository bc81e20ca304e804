#pragma once

#include <array>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// A value for each of three predictions of the same motion.
using OfThree = std::array<double, 3>;

/// Weights with the sum 1, each proportional to the inverse of the prediction's mean square error to the power `power`.
/// With the power 1 and independent errors, this mean has the least variance (Bates and Granger 1969); a high power
/// comes close to the choice of the best prediction, but is continuous.
[[nodiscard]] OfThree inverse_power_weights(const OfThree& mean_square_m2, double power) noexcept;

/// Squared errors of the predictions for one instant, as means over the body's cells [m²].
struct SquareErrors {
  double own = 0.0;       ///< the station's own prediction, by the shared motion and the breathing model
  double holding = 0.0;   ///< the surface stays as it is
  double straight = 0.0;  ///< each cell goes on at its own velocity (StraightMotion)
  double mean = 0.0;      ///< PredictionWeights::short_term(), as it was when the prediction was made
};

/// The weights of three predictions for the whole body at one age of the prediction, learned from their errors on two
/// time scales in series. First, the three are averaged with weights from the errors of the last 0.3 s; this mean
/// follows a shift. Then the station's own prediction, holding, and this mean are averaged with weights from the errors
/// of the last ten seconds. The long scale finds that a patient coughs, for whom no prediction is right in time, so
/// that holding is best.
class PredictionWeights {
 public:
  /// Adds the errors of the predictions that were made for this instant, `dt_s` after the last frame.
  void add(const SquareErrors& errors, double dt_s) noexcept;
  /// Lets `dt_s` pass without errors, as when the frame for which the predictions were made is missing.
  void pass(double dt_s) noexcept;

  /// Weights of own, holding and straight.
  [[nodiscard]] OfThree short_term() const noexcept;
  [[nodiscard]] OfThree weights() const noexcept;

 private:
  OfThree lately_m2_s_{};  ///< own, holding, straight: sums over 0.3 s
  OfThree long_m2_s_{};    ///< own, holding, mean: sums over ten seconds
  double prior_ = 1.0;     ///< weight of the prior that the station's own prediction is best
};

}  // namespace telepalp::surface
