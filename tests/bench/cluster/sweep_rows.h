#pragma once

#include <filesystem>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Runs a sweep without workers, with one, with two, and with two of which one is killed. Adds rows for the times, the
/// result files that differ, and the runs that the killed worker makes necessary again.
[[nodiscard]] Result<void> add_sweep_rows(const std::filesystem::path& scratch, std::vector<Row>& rows);

}  // namespace telepalp::bench
