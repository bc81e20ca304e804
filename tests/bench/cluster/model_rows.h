#pragma once

#include <filesystem>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Measures what an edge with keys and the NATS server use, and compares the model of `telepalp-link edges` that has
/// these costs with 1, 2 and 4 edges of other sizes and another content. `seconds`: of each measurement.
[[nodiscard]] Result<void> add_model_rows(const std::filesystem::path& scratch, double seconds, std::vector<Row>& rows);

}  // namespace telepalp::bench
