#include "tests/bench/distribution.h"

#include <limits>

#include "proto/words/numbers/quantile.h"

namespace telepalp::bench {

double Distribution::quantile(double q) const {
  if (samples_.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values = samples_;
  return quantile_of(values, q);
}

}  // namespace telepalp::bench
