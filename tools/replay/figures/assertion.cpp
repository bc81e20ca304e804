#include "tools/replay/figures/assertion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

#include "proto/words/number_word.h"

namespace telepalp::replay {
namespace {

constexpr const char* kWhere = "--assert";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// Levenshtein's distance: the least number of characters to insert, remove or replace.
std::size_t edits(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

Error unknown_metric(std::string_view name) {
  const auto nearest = std::min_element(metrics().begin(), metrics().end(), [&](const Metric& a, const Metric& b) {
    return edits(name, a.name) < edits(name, b.name);
  });
  return {.what = "'" + std::string(name) + "' is not a metric; the nearest is " + std::string(nearest->name),
          .where = kWhere,
          .fix = "give one of " + metric_names()};
}

Result<Assertion> parse_one(std::string_view text) {
  const std::size_t at = text.find_first_of("<>");
  if (at == std::string_view::npos)
    return Error{.what = "'" + std::string(text) + "' has no comparison",
                 .where = kWhere,
                 .fix = "give METRIC<NUMBER, with <, <=, > or >="};
  const bool or_equal = at + 1 < text.size() && text[at + 1] == '=';
  const std::string_view name = trimmed(text.substr(0, at));
  const std::string_view limit = trimmed(text.substr(at + (or_equal ? 2 : 1)));
  Assertion assertion{.metric = find_metric(name), .text = std::string(text)};
  if (assertion.metric == nullptr) return unknown_metric(name);
  assertion.comparison = text[at] == '<' ? (or_equal ? Comparison::AtMost : Comparison::Less)
                                         : (or_equal ? Comparison::AtLeast : Comparison::More);
  const std::optional<double> number = finite_number_of(limit);
  if (!number)
    return Error{.what = "'" + std::string(limit) + "' in '" + std::string(text) + "' is not a number",
                 .where = kWhere,
                 .fix = "give a finite number after the comparison"};
  assertion.limit = *number;
  return assertion;
}

bool holds(const Assertion& assertion, double value) noexcept {
  switch (assertion.comparison) {
    case Comparison::Less:
      return value < assertion.limit;
    case Comparison::AtMost:
      return value <= assertion.limit;
    case Comparison::More:
      return value > assertion.limit;
    case Comparison::AtLeast:
      return value >= assertion.limit;
  }
  return false;
}

std::string reason(const Assertion& assertion, double value) {
  if (!std::isfinite(value))
    return std::string(assertion.metric->name) + " cannot be computed: this run has no data for it";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return std::string(assertion.metric->name) + " is " + text.data();
}

}  // namespace

Result<std::vector<Assertion>> parse_assertions(std::string_view text) {
  std::vector<Assertion> assertions;
  while (!trimmed(text).empty()) {
    const std::size_t comma = text.find(',');
    Result<Assertion> one = parse_one(trimmed(text.substr(0, comma)));
    if (!one) return one.error();
    assertions.push_back(std::move(*one));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return assertions;
}

std::vector<Judgement> judge(const std::vector<Assertion>& assertions, const Figures& figures) {
  std::vector<Judgement> judgements;
  for (const Assertion& assertion : assertions) {
    const double value = figures.*assertion.metric->value;
    const bool held = holds(assertion, value);
    judgements.push_back({assertion.text, held, held ? "" : reason(assertion, value)});
  }
  return judgements;
}

}  // namespace telepalp::replay
