#include "clients/record/live/amounts.h"

#include <charconv>
#include <optional>
#include <span>

namespace telepalp::record {
namespace {

struct Unit {
  std::string_view name;
  double factor;
};
constexpr Unit kTimes[] = {{"", 1.0}, {"s", 1.0}, {"ms", 1e-3}, {"min", 60.0}, {"h", 3600.0}};
constexpr Unit kSizes[] = {{"", 1.0},   {"B", 1.0},         {"kB", 1e3},          {"MB", 1e6},
                           {"GB", 1e9}, {"MiB", 1048576.0}, {"GiB", 1073741824.0}};

std::optional<double> parse(std::string_view text, std::span<const Unit> units) {
  double number = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc{} || !(number >= 0.0)) return std::nullopt;
  const std::string_view name(end, static_cast<std::size_t>(text.data() + text.size() - end));
  for (const Unit& unit : units)
    if (unit.name == name) return number * unit.factor;
  return std::nullopt;
}

Error wrong(std::string_view text, std::string_view option, const char* what, const char* fix) {
  return {.what = "'" + std::string(text.substr(0, 64)) + "' is not " + what,
          .where = "--" + std::string(option),
          .fix = fix};
}

}  // namespace

Result<Nanoseconds> parse_duration(std::string_view text, std::string_view option) {
  constexpr double kMost_s = 1000.0 * 86400.0;
  const std::optional<double> seconds = parse(text, kTimes);
  if (!seconds || *seconds > kMost_s)
    return wrong(text, option, "a duration of at most 1000 days",
                 "give a number with ms, s, min or h, such as 90s or 5min");
  return Nanoseconds(static_cast<std::int64_t>(*seconds * 1e9));
}

Result<std::uint64_t> parse_size(std::string_view text, std::string_view option) {
  const std::optional<double> bytes = parse(text, kSizes);
  if (!bytes || *bytes < 1.0 || *bytes > 1e15)
    return wrong(text, option, "a size from 1 B to 1000 TB", "give a number with kB, MB or GB, such as 500MB");
  return static_cast<std::uint64_t>(*bytes);
}

bool is_size(std::string_view text) noexcept {
  return !text.empty() && std::string_view("BkMG").find(text.back()) != std::string_view::npos;
}

}  // namespace telepalp::record
