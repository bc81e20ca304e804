#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// The two ledgers of energy and the work of lift and position control, over time. Empty without a station.
[[nodiscard]] std::vector<plot::Chart> energy(const Session& session);

/// How long the warm motors could still hold the force, over time. Empty when they always could.
[[nodiscard]] std::vector<plot::Chart> heat(const Session& session);

}  // namespace telepalp::report
