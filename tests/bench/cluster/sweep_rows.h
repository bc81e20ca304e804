#pragma once

#include <filesystem>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// A sweep by telepalp-replay alone, by one and by two telepalp-worker, and by two of which one is killed: adds rows of
/// the speed, of files that differ, and of what the killed worker costs.
[[nodiscard]] Result<void> add_sweep_rows(const std::filesystem::path& scratch, std::vector<Row>& rows);

}  // namespace telepalp::bench
