#pragma once

#include <cstdint>
#include <optional>

#include "proto/words/frames.h"

namespace telepalp::trials {

struct BlindSearchSettings {
  std::uint64_t seed = 1;
  bool with_cylinder = true;  ///< S1's, its axis anywhere within `half_width_m` of the middle
  double half_width_m = 0.05;
  double breathing_m = 0.003;
  double tremor_m = 0.0005;  ///< of the hand, at 9 Hz
  double weber = 0.10;       ///< standard deviation of what the person feels of a force, as a share
};

struct BlindSearchOutcome {
  bool found = false;            ///< the person says that something lies there
  Point<HapticBase> where;       ///< at the stiffest place, on the skin
  Point<HapticBase> cylinder;    ///< where it was; meaningless without one
  double strongest_ratio = 0.0;  ///< of the stiffness felt there to that of the median place
};

/// A hand that knows only its own depth and the force it feels presses on a grid of places and says whether one is
/// stiffer than the others (S1's fourth trial). Runs the whole controller in virtual time.
[[nodiscard]] BlindSearchOutcome search_blindly(const BlindSearchSettings& settings);

}  // namespace telepalp::trials
