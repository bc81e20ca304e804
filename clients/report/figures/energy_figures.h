#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// Energies over time: energy taken from the hand less energy stored (the passivity observer), work on the hand beyond
/// that of the measured skin, and work of the lift away from the body and of position control. Empty without a station.
[[nodiscard]] std::vector<plot::Chart> energy(const Session& session);

/// Time until the warm motors must lower the force, over time. Empty when they never must.
[[nodiscard]] std::vector<plot::Chart> heat(const Session& session);

}  // namespace telepalp::report
