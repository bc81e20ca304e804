#include "haptic_station/probe/trajectory.h"

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "proto/words/error_line.h"
#include "support/models/text_cursor.h"

namespace telepalp::probe {
namespace {

using models::TextCursor;

constexpr std::size_t kMostWaypoints = 20'000'000;

/// The four numbers of a line; a word that is not a number becomes NaN. nullopt unless there are four words.
std::optional<std::array<double, 4>> four_numbers(std::string_view line, bool& all_numbers) {
  std::array<double, 4> values{};
  all_numbers = true;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t comma = line.find(',');
    if ((comma == std::string_view::npos) != (k == 3)) return std::nullopt;
    std::string_view cell = line.substr(0, comma);
    const auto value = TextCursor::number<double>(TextCursor::word_of(cell));
    all_numbers = all_numbers && value.has_value();
    values[k] = value.value_or(std::numeric_limits<double>::quiet_NaN());
    if (k < 3) line.remove_prefix(comma + 1);
  }
  return values;
}

}  // namespace

Result<std::vector<Waypoint>> parse_trajectory(std::string_view text, const std::string& name) {
  const std::string fix = "write lines t_s,x,y,z: seconds that do not decrease, and metres in the cloud's frame";
  std::vector<Waypoint> waypoints;
  TextCursor cursor(text);
  while (!cursor.at_end()) {
    const std::string_view line = cursor.line();
    if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
    const std::string where = name + ":" + std::to_string(cursor.line_number());
    bool all_numbers = false;
    const auto values = four_numbers(line, all_numbers);
    if (!values) return Error{.what = "does not have four columns", .where = where, .fix = fix};
    const auto& [t_s, x, y, z] = *values;
    if (!all_numbers && waypoints.empty() && line.find("t_s") != std::string_view::npos) continue;  // the header
    if (!std::isfinite(t_s)) return Error{.what = "the first column is not a finite time", .where = where, .fix = fix};
    if (!waypoints.empty() && t_s < waypoints.back().t_s)
      return Error{
          .what = "the time decreases from " + number_text(waypoints.back().t_s) + " s to " + number_text(t_s) + " s",
          .where = where,
          .fix = "sort the lines by time"};
    if (waypoints.size() == kMostWaypoints)
      return Error{.what = "has over 20 million lines", .where = name, .fix = "give fewer lines"};
    waypoints.push_back({t_s, {x, y, z}});
  }
  if (waypoints.empty()) return Error{.what = "has no waypoints", .where = name, .fix = fix};
  return waypoints;
}

Result<std::vector<Waypoint>> read_trajectory(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    return Error{.what = "cannot be read, or is empty",
                 .where = file.string(),
                 .fix = "check the path, your permissions, and that the file has lines"};
  return parse_trajectory(text.str(), file.string());
}

}  // namespace telepalp::probe
