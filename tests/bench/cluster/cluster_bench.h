#pragma once

#include "support/program/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// A real server that publishes to real NATS servers, and a real edge: the delay that the relay adds, what an edge and
/// the publishing cost, and a node of the cluster that is killed or frozen.
[[nodiscard]] Result<Report> run_cluster(const program::Arguments& arguments);

}  // namespace telepalp::bench
