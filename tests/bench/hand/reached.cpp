#include "tests/bench/hand/reached.h"

#include <charconv>
#include <cmath>
#include <fstream>

namespace telepalp::bench::hand {
namespace {

constexpr double kSlackShare = 0.1;

}  // namespace

Result<Reached> read_reached(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream)
    return Error{.what = "the file cannot be read",
                 .where = file.string(),
                 .fix = "give a reached.tsv, which telepalp-bench hand --write DIR writes"};
  Reached reached;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::size_t tab = line.find('\t');
    double value = 0.0;
    const auto [end, code] = std::from_chars(line.data(), line.data() + std::min(tab, line.size()), value);
    if (tab == std::string::npos || code != std::errc{} || end != line.data() + tab)
      return Error{.what = "the line is not VALUE, tab, NAME",
                   .where = file.string() + ", line " + std::to_string(number),
                   .fix = "write the file anew: telepalp-bench hand --write DIR"};
    reached[line.substr(tab + 1)] = value;
  }
  return reached;
}

Result<void> write_reached(const Report& report, const std::filesystem::path& file) {
  std::ofstream stream(file);
  stream.precision(4);
  for (const Row& row : report.rows)
    if (!row.holds() && std::isfinite(row.value)) stream << row.value << '\t' << row.name << '\n';
  stream.close();
  if (stream) return {};
  return Error{.what = "cannot be written",
               .where = file.string(),
               .fix = "check that the folder exists and that the disk has space"};
}

void accept_reached(const Reached& reached, Report& report) {
  for (Row& row : report.rows) {
    const auto found = reached.find(row.name);
    if (row.holds() || found == reached.end()) continue;
    const double slack = kSlackShare * std::abs(found->second);
    row.reach = row.bound == Bound::AtMost ? found->second + slack : found->second - slack;
    row.name += " (missed, accepted by --reached)";
  }
}

}  // namespace telepalp::bench::hand
