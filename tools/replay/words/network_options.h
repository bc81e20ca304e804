#pragma once

#include <vector>

#include "support/program/options.h"
#include "tools/replay/scenario/scenario.h"

namespace telepalp::replay {

/// The options that describe the network and the faults of a run.
[[nodiscard]] std::vector<program::Option> network_options();

/// The scenario that these options describe: a named network profile, in which further options replace values. The
/// default deadline is usual_deadline(): no frame arrives before the delay from server to station has passed.
[[nodiscard]] Result<Scenario> read_scenario(const program::Arguments& arguments);

/// The deadline after capture if the user gives none: 100 ms plus the delay from server to station.
[[nodiscard]] inline Nanoseconds usual_deadline(const impaired::Impairment& down) noexcept {
  return std::chrono::milliseconds(100) + down.delay;
}

}  // namespace telepalp::replay
