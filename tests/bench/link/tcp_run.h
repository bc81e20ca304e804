#pragma once

#include <optional>
#include <string>

#include "tests/bench/link/link_scenario.h"

namespace telepalp::bench::link {

/// The kernel's TCP between two network namespaces, whose packets pass the scenario's path one by one, in real time.
/// The sender keeps little unsent in the kernel, and a newer image replaces one that waits. nullopt: this machine
/// permits no namespaces or no TUN devices.
[[nodiscard]] std::optional<Outcome> run_kernel_tcp(const Scenario& scenario);

/// For example "cubic".
[[nodiscard]] std::string kernel_congestion_control();

}  // namespace telepalp::bench::link
