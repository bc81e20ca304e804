#pragma once

#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/bill/billed_station.h"

namespace telepalp::bench {

/// Processor time of the whole station with `scene`, while its simulated hand does its trial, in virtual time: each
/// step follows the one before it at once. Without the waking of the live thread and without sockets. `name`: of the
/// scene's file in the library. Takes some seconds.
[[nodiscard]] Result<station::StationCost> cost_of_station(const scenes::Scene& scene, const std::string& name);

}  // namespace telepalp::bench
