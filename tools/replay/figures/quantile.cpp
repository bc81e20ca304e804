#include "tools/replay/figures/quantile.h"

#include <cmath>
#include <limits>

#include "proto/words/numbers/quantile.h"

namespace telepalp::replay {

double quantile(std::vector<float> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  for (float& value : values) value = std::abs(value);
  return double{quantile_of(values, share)};
}

}  // namespace telepalp::replay
