#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// What was done about delay, over time: how old hand and surface were, by how much each was carried forward, with its
/// 1-sigma, and what was kept back so that nothing stepped. Empty when the session does not tell.
[[nodiscard]] std::vector<plot::Chart> compensation(const Session& session);

}  // namespace telepalp::report
