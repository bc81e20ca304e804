#pragma once

#include <filesystem>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Rows of sessions that are recorded in a cluster of three nodes: messages lost when each node in turn is killed, and
/// bytes that differ after a copy to the cluster and back. `seconds`: length of each recording, at least 8.
[[nodiscard]] Result<void> add_session_rows(const std::filesystem::path& scratch, double seconds,
                                            std::vector<Row>& rows);

}  // namespace telepalp::bench
