#pragma once

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Runs the request's source once over its network, prints the report and writes the files of --out. True: all
/// assertions hold.
[[nodiscard]] Result<bool> run_once(const Request& request);

/// Reads a steady clock, for costs.
[[nodiscard]] std::int64_t steady_ns() noexcept;

}  // namespace telepalp::replay
