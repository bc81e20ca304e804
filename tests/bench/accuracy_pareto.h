#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace telepalp::bench {

/// A way to do something: what it errs and what it costs, both positive, less is better.
struct Tradeoff {
  double error = 0.0;
  double cost = 0.0;
  bool allowed = true;  ///< keeps every other promise, so that it may be the knee
};

/// Those that no other beats in both, by rising cost.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const Tradeoff> all);

/// Of those allowed, the one with the least error × cost: from there, either gets better only by making the other worse
/// by a larger factor. `all.size()` when none is allowed.
[[nodiscard]] std::size_t knee_of(std::span<const Tradeoff> all);

}  // namespace telepalp::bench
