#pragma once

#include <cstdint>

#include "haptic_station/scenes/scene.h"

namespace telepalp::bench {

/// Ribs that a finger crossed, by the geometry of the scene, and ribs that a script counted from the force alone.
struct RibCount {
  int crossed = 0;
  int counted = 0;
  double worst_step_N = 0.0;  ///< largest change of the effects' force in a tick
};

/// A finger slides along the chest, beside the breastbone, with a tremor. `seed` chooses side, place, depth, speed and
/// tremor.
[[nodiscard]] RibCount count_ribs(const scenes::Scene& scene, std::uint64_t seed);

struct Mass {
  double size_m;   ///< diameter
  double depth_m;  ///< of its top below the skin
  double stiffness_N_per_m;
};

/// True when a script finds the mass, at a place that `seed` chooses, by pressing with 8 N on a grid of 15 mm over an
/// area of 90 mm, and names a place within 15 mm of it. The script knows only the depths that it reached.
[[nodiscard]] bool finds_mass(const Mass& mass, std::uint64_t seed);

}  // namespace telepalp::bench
