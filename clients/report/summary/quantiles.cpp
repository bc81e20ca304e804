#include "clients/report/summary/quantiles.h"

#include <algorithm>
#include <cmath>

namespace telepalp::report {

Quantiles quantiles(std::vector<double> samples) {
  std::erase_if(samples, [](double sample) { return !std::isfinite(sample); });
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const auto rank = [&](double share) {
    const auto index = static_cast<std::size_t>(std::ceil(share * static_cast<double>(samples.size())));
    return samples[std::clamp<std::size_t>(index, 1, samples.size()) - 1];
  };
  return {rank(0.5), rank(0.99), rank(0.999), samples.back(), samples.size()};
}

}  // namespace telepalp::report
