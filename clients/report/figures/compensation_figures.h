#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// Charts of the delay compensation over time: age of hand and surface, their predicted displacements with standard
/// deviations, the decaying offset that smooths the step from one surface to the next, and how each object in the body
/// follows the skin. Empty when the session has no compensation messages.
[[nodiscard]] std::vector<plot::Chart> compensation(const Session& session);

}  // namespace telepalp::report
