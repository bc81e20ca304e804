#pragma once

#include <filesystem>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Rows of a cluster whose third node, which the edge uses, is cut off from all others for 5 s: it runs in a network
/// namespace of its own, whose device goes down. A doctor's station touches at the site meanwhile. Needs root.
[[nodiscard]] Result<void> add_partition_rows(const std::filesystem::path& scratch, std::vector<Row>& rows);

}  // namespace telepalp::bench
