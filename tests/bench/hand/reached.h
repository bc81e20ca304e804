#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench::hand {

/// Figures that rows have reached, by name. A row that does not hold yet is kept from becoming worse by them.
using Reached = std::map<std::string, double>;

/// Reads lines of VALUE, tab, NAME.
[[nodiscard]] Result<Reached> read_reached(const std::filesystem::path& file);

/// Those rows of `report` that are asked for something and do not hold, one a line, to `file`.
[[nodiscard]] Result<void> write_reached(const Report& report, const std::filesystem::path& file);

/// A row that does not hold but is no more than a tenth worse than what it once reached holds after this; its name says
/// so.
void accept_reached(const Reached& reached, Report& report);

}  // namespace telepalp::bench::hand
