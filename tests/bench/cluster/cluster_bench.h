#pragma once

#include "support/program/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// A real server publishes to real NATS servers, and a real edge shows the same images. Measures the delay that the
/// relay adds, the processor time of the edge and of publishing, and the gap after a node of the cluster is killed or
/// frozen. Compares the model of `telepalp-link edges` with edges, runs all programs for --seconds (soak), and lets
/// real workers make a sweep. --part: relay, nodes, model, soak or sweep.
[[nodiscard]] Result<Report> run_cluster(const program::Arguments& arguments);

}  // namespace telepalp::bench
