#include "tests/bench/users/section.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace telepalp::bench {
namespace {

Error not_a_row(const std::string& line, const std::string& script) {
  return {.what = "'" + line + "' is not a row",
          .where = script,
          .fix = "print name, value, unit, at_most|at_least|none and the budget, separated by tabs"};
}

Result<Row> read_row(const std::string& line, const std::string& script) {
  std::istringstream cells(line);
  std::string name, value, unit, bound, reach;
  for (std::string* cell : {&name, &value, &unit, &bound, &reach})
    if (!std::getline(cells, *cell, '\t')) return not_a_row(line, script);
  const double number = std::strtod(value.c_str(), nullptr);
  const double budget = std::strtod(reach.c_str(), nullptr);
  if (bound == "at_most") return at_most(name, number, unit, budget);
  if (bound == "at_least") return at_least(name, number, unit, budget);
  if (bound == "none") return measured(name, number, unit);
  return not_a_row(line, script);
}

}  // namespace

Result<std::vector<Row>> rows_of_script(const UsersPlace& place, const std::filesystem::path& script) {
  const std::string command = "node " + quoted(script) + " " + quoted(place.programs) + " " + quoted(place.viewer);
  const Error failed{.what = "the script failed", .where = command, .fix = "see its message above"};
  FILE* pipe = ::popen(command.c_str(), "re");
  if (pipe == nullptr) return failed;
  std::string text;
  for (int letter = 0; (letter = std::fgetc(pipe)) != EOF;) text += static_cast<char>(letter);
  const int status = ::pclose(pipe);
  std::vector<Row> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Result<Row> row = read_row(line, script.string());
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  if (status != 0 || rows.empty()) return failed;
  return rows;
}

}  // namespace telepalp::bench
