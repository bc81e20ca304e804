#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// Energies over time: energy taken from the hand less energy stored (the passivity observer), work on the hand beyond
/// that of the measured skin, and work of position control, which moves the device. Empty without /station/state.
[[nodiscard]] std::vector<plot::Chart> energy(const Session& session);

/// Time until the warm motors must lower the force, over time. Empty if no /station/state states such a time.
[[nodiscard]] std::vector<plot::Chart> heat(const Session& session);

}  // namespace telepalp::report
