#pragma once

#include <cstdint>
#include <optional>

#include "haptic_station/scenes/scene.h"

namespace telepalp::bench {

/// Ribs that a finger crossed, by the geometry of the scene, and ribs that a script counted from the force alone.
struct RibCount {
  int crossed = 0;
  int counted = 0;
  double worst_step_N = 0.0;  ///< largest change of the effects' force in a tick
};

/// A finger presses beside the breastbone between two ribs, slides along the chest, and lifts between two others. It
/// has a tremor. `seed` chooses side, place, depth, speed, start and end of the slide, and the tremor.
[[nodiscard]] RibCount count_ribs(const scenes::Scene& scene, std::uint64_t seed);

struct Mass {
  double size_m;   ///< diameter
  double depth_m;  ///< of its top below the skin
  double stiffness_N_per_m;
};

/// The outcome of a search, and the time that the hand took for it.
struct MassSearch {
  bool named = false;   ///< the script named a place
  bool right = false;   ///< and a mass lies within 15 mm of it
  double hand_s = 0.0;  ///< pressing at 30 mm/s, and 0.3 s from one place to the next
};

/// A script presses a fingertip of 8 mm radius with 8 N on a grid of 10 mm over an area of 90 mm, and names the place
/// of the least depth if that is 1 mm less than the median. It knows only the depths. `seed` chooses the place of the
/// mass. `mass`: nullopt: there is none, so that any named place is a false alarm.
[[nodiscard]] MassSearch search_mass(const std::optional<Mass>& mass, std::uint64_t seed);

}  // namespace telepalp::bench
