#pragma once

#include <cstdint>
#include <optional>

#include "proto/words/frames.h"

namespace telepalp::trials {

struct BlindSearchSettings {
  std::uint64_t seed = 1;
  bool with_cylinder = true;   ///< hide S1's cylinder at a random place of the searched square
  double breathing_m = 0.003;  ///< amplitude of the skin's rise and fall
  bool by_camera = false;      ///< a Kinect-like camera sees a curved skin; false: the skin is level, its surface exact
};

struct BlindSearchOutcome {
  bool found = false;            ///< the person reports a hidden object
  Point<HapticBase> where;       ///< where the person reports it: the stiffest place, at the skin's mean height
  Point<HapticBase> cylinder;    ///< point of the skin above the cylinder; meaningless without a cylinder
  int places_unfelt = 0;         ///< number of places where a hand over 25 mm deep never felt 20 N/m (force / depth)
  double strongest_ratio = 0.0;  ///< perceived stiffness (force / depth) at the stiffest place / at the median place
};

/// Simulates the fourth trial of paper S1 (docs/sources.md): a person who knows only the depth of the hand and the
/// perceived force presses on a grid of 4 × 4 places and reports whether one is stiffer than the others. The station's
/// haptic loop runs in virtual time. `found` is false if a place was not felt.
[[nodiscard]] BlindSearchOutcome search_blindly(const BlindSearchSettings& settings);

}  // namespace telepalp::trials
