#pragma once

#include <string>
#include <vector>

#include "tools/replay/figures/metrics.h"
#include "tools/replay/words/sweep_axes.h"

namespace telepalp::replay {

/// The figures of a sweep: `figures[i]` are those of `cells[i]`.
struct SweepResult {
  const std::vector<SweepAxis>& axes;
  const std::vector<SweepCell>& cells;
  std::vector<Figures> figures;
};

/// One line for each cell, with its values on the axes and the eight metrics that the first line names.
[[nodiscard]] std::string sweep_text(const SweepResult& result);
/// One line for each cell, with all metrics; the first line names the columns.
[[nodiscard]] std::string sweep_csv(const SweepResult& result);
[[nodiscard]] std::string sweep_json(const SweepResult& result, const std::string& source);
/// A heat map, as SVG, of the metric over the first two axes, at the first value of each other axis.
[[nodiscard]] std::string sweep_map(const SweepResult& result, const Metric& metric);

}  // namespace telepalp::replay
