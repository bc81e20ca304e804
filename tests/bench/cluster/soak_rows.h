#pragma once

#include <filesystem>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// A server, a recorder, a NATS server and an edge with 20 viewers, and a station that touches, in two network
/// namespaces that `telepalp-link --profile lte` joins, for `seconds` (at least 60). After a third of this time the
/// edge's certificate is renewed and the edge restarted. Rows: memory, descriptors, faults, and the force at each tick.
/// Error: this kernel allows no network namespaces, or a program does not start.
[[nodiscard]] Result<void> add_soak_rows(const std::filesystem::path& scratch, double seconds, std::vector<Row>& rows);

}  // namespace telepalp::bench
