#pragma once

#include <filesystem>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Rows of a cluster of three nodes that loses one: the edge's or the site's is killed, the edge's is frozen for 5 s,
/// or is cut off for 5 s (add_partition_rows(), which needs root). Meanwhile a doctor's station touches at the site.
[[nodiscard]] Result<void> add_node_rows(const std::filesystem::path& scratch, std::vector<Row>& rows);

}  // namespace telepalp::bench
