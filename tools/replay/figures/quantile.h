#pragma once

#include <vector>

namespace telepalp::replay {

/// The quantile of the values' magnitudes, `share` from 0 to 1; NaN if there are no values.
[[nodiscard]] double quantile(std::vector<float> values, double share);

}  // namespace telepalp::replay
