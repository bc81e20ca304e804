#include "support/plot/thin.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "proto/words/demand.h"
#include "support/plot/scale.h"

namespace telepalp::plot {
namespace {

/// The samples that represent one pixel column.
struct Column {
  std::size_t first, least, greatest, last;
};

void keep(const Column& column, std::vector<std::size_t>& kept) {
  std::array<std::size_t, 4> indices{column.first, column.least, column.greatest, column.last};
  std::sort(indices.begin(), indices.end());
  for (const std::size_t index : indices)
    if (kept.empty() || kept.back() != index) kept.push_back(index);
}

}  // namespace

std::vector<std::size_t> thin_keeping_extremes(std::span<const double> x, std::span<const double> y,
                                               std::size_t columns) {
  demand(x.size() == y.size() && columns > 0, "a curve has as many x values as y values, and at least one column");
  const Range range = range_of(x, {0.0, 1.0});
  const double per_unit = range.most > range.least ? static_cast<double>(columns) / (range.most - range.least) : 0.0;
  const auto column_of = [&](std::size_t i) { return std::floor((x[i] - range.least) * per_unit); };

  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < x.size();) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
      kept.push_back(i);
      while (i < x.size() && (!std::isfinite(x[i]) || !std::isfinite(y[i]))) ++i;
      continue;
    }
    Column run{i, i, i, i};
    const double column = column_of(i);
    for (; i < x.size() && std::isfinite(x[i]) && std::isfinite(y[i]) && column_of(i) == column; ++i) {
      if (y[i] < y[run.least]) run.least = i;
      if (y[i] > y[run.greatest]) run.greatest = i;
      run.last = i;
    }
    keep(run, kept);
  }
  return kept;
}

std::vector<std::size_t> thin_path(std::span<const double> x, std::span<const double> y, double distance) {
  demand(x.size() == y.size(), "a path has as many x values as y values");
  std::vector<std::size_t> kept;
  bool gap = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool finite = std::isfinite(x[i]) && std::isfinite(y[i]);
    if (!finite && gap) continue;
    const bool is_kept =
        !finite || gap || std::hypot(x[i] - x[kept.back()], y[i] - y[kept.back()]) >= distance || i + 1 == x.size();
    if (is_kept) kept.push_back(i);
    gap = !finite;
  }
  return kept;
}

}  // namespace telepalp::plot
