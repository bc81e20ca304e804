#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench::hand {

/// Values that rows have reached, by name. They keep a row that misses its requirement from becoming worse.
using Reached = std::map<std::string, double>;

/// Reads lines of VALUE, tab, NAME.
[[nodiscard]] Result<Reached> read_reached(const std::filesystem::path& file);

/// Writes the rows of `report` that miss their requirement to `file`, one per line.
[[nodiscard]] Result<void> write_reached(const Report& report, const std::filesystem::path& file);

/// Accepts each row that misses its requirement but is at most a tenth worse than its reached value; its name states
/// this.
void accept_reached(const Reached& reached, Report& report);

}  // namespace telepalp::bench::hand
