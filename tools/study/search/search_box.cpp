#include "tools/study/search/search_box.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "proto/words/error_line.h"
#include "proto/words/number_word.h"

namespace telepalp::study {
namespace {

constexpr double kMost_mm = 1000.0;
constexpr double kMost_rad = 6.2832;
constexpr const char* kFix = "give MIN:MAX, lengths in mm and angles in rad, such as 80:120, or one number to fix it";

std::string parameter_names() {
  std::string names;
  for (const MechanismParameter& one : mechanism_parameters())
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names;
}

const MechanismParameter* parameter_of(std::string_view name) {
  for (const MechanismParameter& one : mechanism_parameters())
    if (one.name == name) return &one;
  return nullptr;
}

Result<void> check_range(const SearchRange& range, const std::string& where) {
  const MechanismParameter* parameter = parameter_of(range.name);
  if (parameter == nullptr)
    return Error{.what = "'" + range.name + "' is no parameter of a mechanism",
                 .where = where,
                 .fix = "give one of " + parameter_names()};
  const bool angle = parameter->unit == 1.0;
  const double most = angle ? kMost_rad : kMost_mm;
  const double least = angle ? -kMost_rad : 0.0;
  for (const double value : {range.least, range.most})
    if (!std::isfinite(value) || value < least || value > most)
      return Error{
          .what = range.name + " = " + number_text(value) + " is out of bounds",
          .where = where,
          .fix = "give numbers from " + number_text(least) + " to " + number_text(most) + (angle ? " rad" : " mm")};
  if (range.least > range.most)
    return Error{.what = "the least " + range.name + ", " + number_text(range.least) + ", is above the most, " +
                         number_text(range.most),
                 .where = where,
                 .fix = "give the smaller number first: " + number_text(range.most) + ":" + number_text(range.least)};
  return {};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void put(SearchBox& box, SearchRange range) {
  const auto known = std::find_if(box.ranges.begin(), box.ranges.end(), [&](auto& r) { return r.name == range.name; });
  if (known == box.ranges.end())
    box.ranges.push_back(std::move(range));
  else
    *known = std::move(range);
}

void set_parameter(Configuration& mechanism, const std::string& name, double value) {
  const MechanismParameter& parameter = *parameter_of(name);
  mechanism.bar.*parameter.value = parameter.unit * value;
  mechanism.l4_given |= name == "l4";
  mechanism.needle_given |= name == "needle";
}

}  // namespace

SearchBox paper_box() {
  SearchBox box;
  const Design paper = amniocentesis_design();
  for (const MechanismParameter& one : mechanism_parameters()) {
    if (one.name == "l4" || one.name == "needle") continue;
    const auto [least, most] =
        std::minmax_element(paper.configurations.begin(), paper.configurations.end(),
                            [&](auto& a, auto& b) { return a.bar.*one.value < b.bar.*one.value; });
    box.ranges.push_back({std::string(one.name), least->bar.*one.value / one.unit, most->bar.*one.value / one.unit});
  }
  return box;
}

Result<void> set_range(SearchBox& box, std::string_view name, std::string_view text, const std::string& where) {
  const std::size_t colon = text.find(':');
  const std::optional<double> least = number_of(text.substr(0, colon));
  const std::optional<double> most = colon == std::string_view::npos ? least : number_of(text.substr(colon + 1));
  if (!least || !most)
    return Error{.what = "'" + std::string(text) + "' is no range of numbers", .where = where, .fix = kFix};
  SearchRange range{std::string(name), *least, *most};
  if (const Result<void> good = check_range(range, where); !good) return good.error();
  put(box, std::move(range));
  return {};
}

Result<SearchBox> parse_box(SearchBox box, const std::string& text, const std::string& file) {
  std::istringstream lines(text);
  std::string line;
  std::vector<std::string> seen;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    const auto place = [&](std::size_t column) {
      return file + ":" + std::to_string(number) + ":" + std::to_string(column + 1);
    };
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos)
      return Error{.what = "'" + std::string(trimmed(line)) + "' has no =",
                   .where = place(first),
                   .fix = "give one parameter in each line, such as l1=80:120"};
    const std::string name(trimmed(std::string_view(line).substr(0, equals)));
    if (std::find(seen.begin(), seen.end(), name) != seen.end())
      return Error{.what = "'" + name + "' is given twice", .where = place(first), .fix = "leave one of them out"};
    seen.push_back(name);
    const std::size_t column = parameter_of(name) == nullptr ? first : equals + 1;
    const std::string_view range = trimmed(std::string_view(line).substr(equals + 1));
    if (const Result<void> set = set_range(box, name, range, place(column)); !set) return set.error();
  }
  return box;
}

Result<SearchBox> checked(const SearchBox& box) {
  for (std::size_t i = 0; i < box.ranges.size(); ++i) {
    const SearchRange& range = box.ranges[i];
    if (const Result<void> good = check_range(range, range.name); !good) return good.error();
    for (std::size_t k = 0; k < i; ++k)
      if (box.ranges[k].name == range.name)
        return Error{.what = "the range is given twice", .where = range.name, .fix = "give each parameter once"};
  }
  if (free_ranges(box).empty())
    return Error{.what = "all parameters are fixed, so there is nothing to search",
                 .where = "the box",
                 .fix = "give at least one parameter as MIN:MAX with MIN below MAX"};
  return box;
}

std::vector<SearchRange> free_ranges(const SearchBox& box) {
  std::vector<SearchRange> free;
  for (const SearchRange& range : box.ranges)
    if (range.least < range.most) free.push_back(range);
  return free;
}

Configuration mechanism_at(const SearchBox& box, const std::vector<double>& unit) {
  Configuration mechanism;
  std::size_t next = 0;
  for (const SearchRange& range : box.ranges) {
    const double share = range.least < range.most ? std::clamp(unit[next++], 0.0, 1.0) : 0.0;
    set_parameter(mechanism, range.name, std::lerp(range.least, range.most, share));
  }
  return mechanism;
}

std::optional<std::vector<double>> place_in(const SearchBox& box, const Configuration& mechanism) {
  constexpr double kSame = 1e-9;  // of a number that was converted to SI units and back
  std::vector<double> unit;
  for (const MechanismParameter& one : mechanism_parameters()) {
    const bool named =
        std::any_of(box.ranges.begin(), box.ranges.end(), [&](const SearchRange& r) { return r.name == one.name; });
    if (!named && std::abs(mechanism::FourBar{}.*one.value - mechanism.bar.*one.value) > kSame) return std::nullopt;
  }
  for (const SearchRange& range : box.ranges) {
    const MechanismParameter& parameter = *parameter_of(range.name);
    const double value = mechanism.bar.*parameter.value / parameter.unit;
    if (value < range.least - kSame || value > range.most + kSame) return std::nullopt;
    const bool drawn =
        (range.name == "l4" && !mechanism.l4_given) || (range.name == "needle" && !mechanism.needle_given);
    if (drawn) return std::nullopt;
    if (range.least < range.most)
      unit.push_back(std::clamp((value - range.least) / (range.most - range.least), 0.0, 1.0));
  }
  return unit;
}

}  // namespace telepalp::study
