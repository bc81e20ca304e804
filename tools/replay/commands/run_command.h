#pragma once

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Runs the request's source once over its network, prints the report and writes the files of --out. True: all
/// assertions hold.
[[nodiscard]] Result<bool> run_once(const Request& request);

/// Reads the steady clock, for speed.
[[nodiscard]] std::int64_t steady_ns() noexcept;
/// Processor time of the calling thread, for the cost of each part: other programs on the machine do not change it.
[[nodiscard]] std::int64_t thread_ns() noexcept;

}  // namespace telepalp::replay
