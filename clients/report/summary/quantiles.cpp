#include "clients/report/summary/quantiles.h"

#include <algorithm>
#include <cmath>

#include "proto/words/numbers/quantile.h"

namespace telepalp::report {

Quantiles quantiles(std::vector<double> samples) {
  std::erase_if(samples, [](double sample) { return !std::isfinite(sample); });
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const auto rank = [&](double share) { return samples[nearest_rank(samples.size(), share)]; };
  return {rank(0.5), rank(0.99), rank(0.999), samples.back(), samples.size()};
}

}  // namespace telepalp::report
