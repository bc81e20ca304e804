#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace telepalp::bench {

/// One alternative with its error and its cost; both are positive, and less is better.
struct Tradeoff {
  double error = 0.0;
  double cost = 0.0;
  bool allowed = true;  ///< meets all other requirements, so that it may be the knee
};

/// Indices of the alternatives that no other one beats in both error and cost, by rising cost.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const Tradeoff> all);

/// Index of the allowed alternative with the least error × cost. From there, an improvement of one value worsens the
/// other by a larger factor. `all.size()` if none is allowed.
[[nodiscard]] std::size_t knee_of(std::span<const Tradeoff> all);

}  // namespace telepalp::bench
