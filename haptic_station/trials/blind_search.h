#pragma once

#include <cstdint>
#include <optional>

#include "proto/words/frames.h"

namespace telepalp::trials {

struct BlindSearchSettings {
  std::uint64_t seed = 1;
  bool with_cylinder = true;   ///< hide S1's cylinder at a random place of the searched square
  double half_width_m = 0.05;  ///< half side of the searched square, about the middle of the skin
  double breathing_m = 0.003;  ///< amplitude of the skin's rise and fall
  double tremor_m = 0.0005;    ///< amplitude of the hand's tremor at 9 Hz
  bool by_camera = false;      ///< the skin is seen by a Kinect-like camera; otherwise level and exact
  double weber = 0.10;         ///< standard deviation of the perceived force / force (Weber fraction)
};

struct BlindSearchOutcome {
  bool found = false;            ///< the person reports a hidden object
  Point<HapticBase> where;       ///< where the person reports it: the stiffest place, on the skin
  Point<HapticBase> cylinder;    ///< the skin above the cylinder's true position; meaningless without a cylinder
  int places_unfelt = 0;         ///< number of places where the hand never felt the skin when 25 mm deep in it
  double strongest_ratio = 0.0;  ///< perceived stiffness at the stiffest place / at the median place
};

/// Simulates the fourth trial of paper S1 (docs/sources.md): a person who knows only the depth of the hand and the
/// perceived force presses on a grid of places and reports whether one is stiffer than the others. The live haptic loop
/// runs in virtual time. If a place was not felt, `found` is false.
[[nodiscard]] BlindSearchOutcome search_blindly(const BlindSearchSettings& settings);

}  // namespace telepalp::trials
