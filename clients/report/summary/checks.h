#pragma once

#include <vector>

#include "clients/report/summary/verdict.h"

namespace telepalp::report {

/// Every check of a run, in the order in which the page shows them.
[[nodiscard]] std::vector<Check> checks_of(const Summary& summary, const PathLimits& path);

/// The share of late ticks that the computer's timer explains [%], at most the share of all late ticks.
[[nodiscard]] double late_by_the_timer_percent(const Summary& summary);

}  // namespace telepalp::report
