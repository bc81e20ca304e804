#pragma once

#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/bill/billed_station.h"

namespace telepalp::bench {

/// Processor time of the whole station with `scene`, while its simulated hand does its trial. Time is virtual: the
/// station computes each tick as soon as the one before is done. So the figure does not hold what a live station pays
/// for waking its thread and for its sockets. `name`: file name of the scene in the library. Takes some seconds.
[[nodiscard]] Result<station::StationCost> cost_of_station(const scenes::Scene& scene, const std::string& name);

}  // namespace telepalp::bench
