#pragma once

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Runs the request's source over its network and over an unimpaired one, prints the report and writes the files of
/// --out. True: all assertions hold and, with --check, no invariant was violated.
[[nodiscard]] Result<bool> run_once(const Request& request);

/// The steady clock [ns], to measure how fast a run is.
[[nodiscard]] std::int64_t steady_ns() noexcept;
/// Processor time of the calling thread [ns], for the cost of each part. Other programs on the machine do not add
/// to this time.
[[nodiscard]] std::int64_t thread_ns() noexcept;

}  // namespace telepalp::replay
