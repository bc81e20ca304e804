#include "tools/replay/figures/quantile.h"

#include <cmath>
#include <limits>

#include "proto/words/numbers/quantile.h"

namespace telepalp::replay {

double quantile(std::vector<float> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  for (float& value : values) value = std::abs(value);
  // Rank floor(share * (n - 1)), not the nearest rank: a repeated run must give the figures of earlier reports.
  const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  return double{value_at_rank(std::span(values), place)};
}

}  // namespace telepalp::replay
