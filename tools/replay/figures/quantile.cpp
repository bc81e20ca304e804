#include "tools/replay/figures/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace telepalp::replay {

double quantile(std::vector<float> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  for (float& value : values) value = std::abs(value);
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return double{values[static_cast<std::size_t>(place)]};
}

}  // namespace telepalp::replay
