#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tools/replay/figures/figures.h"

namespace telepalp::replay {

/// One named figure, for reports and assertions.
struct Metric {
  std::string_view name;  ///< ends with the unit: "force_rmse_N"
  std::string_view what;  ///< description for people
  double Figures::*value;
};
[[nodiscard]] std::span<const Metric> metrics() noexcept;
/// nullptr: no metric has this name.
[[nodiscard]] const Metric* find_metric(std::string_view name) noexcept;
/// The names with commas between them.
[[nodiscard]] std::string metric_names();

/// A table with one row for each metric: its name, its value in `unimpaired` and in `figures`, and its description
/// Metric::what.
[[nodiscard]] std::string text_table(const Figures& unimpaired, const Figures& figures);

}  // namespace telepalp::replay
