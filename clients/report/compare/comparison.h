#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/report/compare/contact_comparison.h"
#include "clients/report/compare/image_comparison.h"
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
  ContactComparison contacts{};
  ImageComparison images{};
  bool messages_compared = false;              ///< true: session times overlap, so messages are comparable
  std::optional<std::string> first_message{};  ///< first differing message, in words; nullopt: none, or not compared
  std::vector<MetricPair> metrics;
  std::vector<MetricPair> replay_metrics;

  /// B's depth divided by A's: of the same images, else the mean of the images that both replays read; NaN (kUnknown)
  /// if neither is known.
  [[nodiscard]] double depth_ratio() const noexcept;

  /// True if the messages were compared and are all equal.
  [[nodiscard]] bool equal() const noexcept { return messages_compared && !first_message; }
};

/// Reads and compares two session files, or folders that telepalp-replay wrote. Error: one of them cannot be read.
[[nodiscard]] Result<Comparison> compare(const std::filesystem::path& a, const std::filesystem::path& b);

/// The result in one sentence: "The hand first feels a difference 3.100 s after the start: …"
[[nodiscard]] std::string headline(const Comparison& comparison);

/// The likely cause of the first felt difference, the settings that differ, and the sizes of the force differences.
[[nodiscard]] std::string account(const Comparison& comparison);

/// Time since the runs' origins (common_origins(), tick_comparison.h) [s] at which the page shows pictures of both
/// runs: at the largest difference of force; without a difference, at the deepest indentation of the first run.
[[nodiscard]] double pictured_s(const Comparison& comparison);

}  // namespace telepalp::report
