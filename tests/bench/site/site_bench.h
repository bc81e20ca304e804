#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Real programs at two sites, each in a network namespace of its own, with the kernel's queues between them.
[[nodiscard]] Result<Report> run_site(const program::Arguments& arguments);

}  // namespace telepalp::bench
