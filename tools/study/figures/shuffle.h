#pragma once

#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "haptic_station/device/random.h"

namespace telepalp::study {

/// Puts the values into a random order, each order with equal probability (Fisher and Yates).
template <class Value>
void shuffle(std::span<Value> values, device::Random& random) {
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(values[i - 1], values[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
}

/// The numbers 0 to `count` - 1 in a random order.
[[nodiscard]] inline std::vector<std::size_t> shuffled(std::size_t count, device::Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(std::span(order), random);
  return order;
}

}  // namespace telepalp::study
