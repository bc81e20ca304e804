#pragma once

#include <array>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::bench {

/// RMS error of a hand prediction, by model, on one recorded hand.
struct HandPredictionError {
  std::string trace;
  double ahead_ms = 0.0;  ///< median, from the newest sample to the one predicted
  std::size_t predictions = 0;
  /// In the order of hand_models(): over all three axes, and along the tracker's height alone, which decides contact.
  std::array<double, 5> all_m{};
  std::array<double, 5> height_m{};
};

inline constexpr std::array<const char*, 5> kHandModels{"hold last", "straight on", "Kalman, constant velocity",
                                                        "Kalman, constant acceleration", "Kalman, damped velocity"};
inline constexpr std::size_t kDefaultHandModel = 4;

/// Each sample of four real traces predicted from those at least 1, 2 and 4 samples (about 9, 18 and 36 ms) before it.
[[nodiscard]] Result<std::vector<HandPredictionError>> hand_predictions();

/// How far the surface of a breathing torso is from where it is said to be, by what carries it forward.
struct SurfacePredictionError {
  std::string model;
  std::string what;
  double still_1s_m = 0.0;              ///< still patient: RMS after one second
  double still_3s_m = 0.0;              ///< and after three
  double step_frames = 0.0;             ///< frames until a sudden step of 3 mm is followed to 0.5 mm
  std::array<double, 4> breathing_m{};  ///< at the ages below, RMS along the normal
};
inline constexpr std::array<double, 4> kSurfaceAges_s{0.0, 0.05, 0.1, 0.2};

/// Temporal filter and prediction, setting by setting, over 1 mm of noise; the breath is 5 mm at 0.25 Hz and known.
[[nodiscard]] Result<std::vector<SurfacePredictionError>> surface_predictions();

}  // namespace telepalp::bench
