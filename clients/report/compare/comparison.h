#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/report/compare/metric_table.h"
#include "clients/report/compare/run.h"
#include "clients/report/compare/settings.h"
#include "clients/report/compare/tick_comparison.h"

namespace telepalp::report {

/// What differs between two runs.
struct Comparison {
  Run a;
  Run b;
  std::vector<Setting> settings;
  TickComparison ticks;
  bool messages_compared = false;              ///< true: session times overlap, so messages are comparable
  std::optional<std::string> first_message{};  ///< the first message in which they differ, in words
  std::vector<MetricPair> metrics;
  std::vector<MetricPair> replay_metrics;

  /// Every message is equal.
  [[nodiscard]] bool equal() const noexcept { return messages_compared && !first_message; }
};

/// Reads and compares two sessions, or folders of telepalp-replay. Error: one of them cannot be read.
[[nodiscard]] Result<Comparison> compare(const std::filesystem::path& a, const std::filesystem::path& b);

/// "The hand first feels a difference 3.100 s after the start: …"
[[nodiscard]] std::string headline(const Comparison& comparison);

/// The likely cause of the first felt difference, the settings that differ, and how large the differences are.
[[nodiscard]] std::string account(const Comparison& comparison);

/// Time since the runs' origins (common_origins(), tick_comparison.h) [s] at which the page shows pictures of both
/// runs: the largest difference of force; for equal forces, the deepest touch of the first run.
[[nodiscard]] double pictured_s(const Comparison& comparison);

}  // namespace telepalp::report
