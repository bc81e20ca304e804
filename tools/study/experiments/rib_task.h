#pragma once

#include <string>
#include <vector>

#include "haptic_station/device/random.h"
#include "haptic_station/effects/effect_bank.h"
#include "proto/words/result.h"

namespace telepalp::study {

/// A chest as the finger feels it: the effects of the scene ribs-ultrasound (paper S2, docs/sources.md, III.A) under a
/// flat skin, and where a slide along it passes the ribs.
struct Chest {
  effects::EffectBank effects;
  std::vector<double> ribs_m;  ///< z of the ribs' tops along the slide, ascending
};

/// Slides along z at this x, beside the breastbone.
inline constexpr double kSlideAt_m = 0.02;
/// The ribs of the scene, and a part of the flank on both sides, lie between these.
inline constexpr double kChestFrom_m = -0.27;
inline constexpr double kChestTo_m = 0.13;
/// Under more than about 1 N the finger sinks between the scene's ribs to below their middle, and catches there:
/// between them the scene has nothing but the skin's spring, where a chest has muscle.
inline constexpr double kLightPress_N = 0.5;
inline constexpr double kFirmPress_N = 0.9;

/// Error: the scene cannot be read, or a slide passes fewer than six ribs.
[[nodiscard]] Result<Chest> read_chest(const std::string& scene);

/// What a slide tells at one sample.
struct SlideSample {
  double z_m = 0.0;
  double height_m = 0.0;  ///< of the finger over the skin at rest; negative inside
  double along_N = 0.0;   ///< force on the finger along the slide
};

/// A finger that presses with `press_N` and slides from `from_m` towards `to_m`, at 2 kHz; samples at 100 Hz. The arm
/// is a mass on a spring that the observer moves along, so the finger lags, and the ribs hold it back and let it go.
/// `wobble_m`: RMS of the tremor along the slide. Pure.
[[nodiscard]] std::vector<SlideSample> slide(const Chest& chest, double press_N, double speed_m_per_s, double from_m,
                                             double to_m, double wobble_m, device::Random& random);

/// A simulated person who counts ribs.
struct RibCounter {
  double speed_m_per_s = 0.04;
  double tremor_m = 1e-4;
  double force_jnd = 0.12;      ///< SD of the felt force, as a share of the press
  double force_floor_N = 0.05;  ///< SD of the felt force, at least
  double height_m = 0.002;      ///< SD of the felt height of the hand
  double sight_m = 7e-4;        ///< SD of the seen height of the finger
  double caution = 4.0;         ///< a change counts from so many standard deviations on
  double lapses = 0.01;         ///< share of the ribs that are noticed and not counted
};

/// How many ribs the person counts in a slide: tops that the force along the slide tells, or the height of the hand.
/// `sees`: the finger's height under the skin is drawn, as in S2 Fig. 4.
[[nodiscard]] int counted_ribs(const RibCounter& person, const std::vector<SlideSample>& samples, double press_N,
                               bool sees, device::Random& random);

}  // namespace telepalp::study
