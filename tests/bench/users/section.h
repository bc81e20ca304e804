#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Where a section of `telepalp-bench users` finds the programs, and where it may write.
struct UsersPlace {
  std::filesystem::path programs;  ///< the folder with telepalp-server and the other programs of this build
  std::filesystem::path viewer;    ///< the folder with the built page
  std::filesystem::path sources;   ///< the checkout
  std::filesystem::path scratch;   ///< an empty folder, removed after the section
};

/// `path` as a word of a shell's command.
[[nodiscard]] inline std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// One group of users' rows; `--part NAME` runs it alone.
struct UsersSection {
  std::string_view name;
  std::string_view purpose;
  Result<std::vector<Row>> (*run)(const UsersPlace& place);
};

/// Runs `node SCRIPT PROGRAMS VIEWER`. Each line that the script prints to stdout is one row: name, value, unit, one of
/// at_most, at_least, none, and the budget, separated by tabs. Its stderr is this program's. Error: the script failed,
/// or printed anything else.
[[nodiscard]] Result<std::vector<Row>> rows_of_script(const UsersPlace& place, const std::filesystem::path& script);

}  // namespace telepalp::bench
