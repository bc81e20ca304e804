#pragma once

#include <array>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::bench {

/// RMS error of a hand prediction, by model, on one recorded hand.
struct HandPredictionError {
  std::string trace;
  double ahead_ms = 0.0;  ///< median time from the newest sample to the predicted one
  std::size_t predictions = 0;
  /// In the order of hand_models(): error over all three axes, and error along the tracker's height, which decides
  /// about contact.
  std::array<double, 5> all_m{};
  std::array<double, 5> height_m{};
};

inline constexpr std::array<const char*, 5> kHandModels{"hold last", "straight line", "fixed noise, constant velocity",
                                                        "fixed noise, damped velocity", "adaptive"};
inline constexpr std::size_t kDefaultHandModel = 4;

/// Predicts each sample of four recorded traces from the samples at least 1, 2 and 4 samples (about 9, 18 and 36 ms)
/// before it.
[[nodiscard]] Result<std::vector<HandPredictionError>> hand_predictions();

/// Processor time of one sample and one prediction of each model [us]; the first two models only copy.
[[nodiscard]] Result<std::array<double, 5>> hand_model_us();

/// The error of the predicted surface of a breathing torso, for one way of prediction.
struct SurfacePredictionError {
  std::string model;
  std::string what;
  double still_1s_m = 0.0;              ///< still patient: RMS after one second
  double still_3s_m = 0.0;              ///< still patient: RMS after three seconds
  double build_ms = 0.0;                ///< processor time of one snapshot, median
  double step_frames = 0.0;             ///< frames until the surface follows a step of 3 mm to 0.5 mm
  std::array<double, 4> breathing_m{};  ///< RMS along the normal at the ages below
};
inline constexpr std::array<double, 4> kSurfaceAges_s{0.0, 0.05, 0.1, 0.2};

/// Temporal filter and prediction, setting by setting, with 1 mm of noise. The breath has 5 mm at 0.25 Hz, and the
/// model has locked on.
[[nodiscard]] Result<std::vector<SurfacePredictionError>> surface_predictions();

}  // namespace telepalp::bench
