#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// Charts of the delay compensation over time: age of hand and surface, their predicted displacements with standard
/// deviations, and the offset that hides steps between snapshots. Empty when the session has no compensation messages.
[[nodiscard]] std::vector<plot::Chart> compensation(const Session& session);

}  // namespace telepalp::report
