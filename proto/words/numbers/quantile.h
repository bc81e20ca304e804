#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace telepalp {

/// The place of a quantile among `count` > 0 sorted values, counted from 0, by the nearest-rank method: the first value
/// that is at least as large as a `share` (0 to 1) of all values.
[[nodiscard]] inline std::size_t nearest_rank(std::size_t count, double share) noexcept {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
  return std::clamp<std::size_t>(rank, 1, count) - 1;
}

/// The value that would be at `place` if the values were sorted. Reorders them.
template <class Value>
[[nodiscard]] Value value_at_rank(std::span<Value> values, std::size_t place) noexcept {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// A quantile of at least one value, by the nearest-rank method. Reorders the values.
template <class Values>
[[nodiscard]] auto quantile_of(Values& values, double share) noexcept {
  return value_at_rank(std::span(values), nearest_rank(values.size(), share));
}

/// The median of at least one value; of an even number, the larger of the two in the middle. Reorders the values.
template <class Values>
[[nodiscard]] auto median_of(Values& values) noexcept {
  return value_at_rank(std::span(values), values.size() / 2);
}

}  // namespace telepalp
