#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/depth_contexts.h"

namespace telepalp::codec {

/// Visits each pixel of a band with its context and symbol, as the coder would, one pixel at a time and without haste:
/// what tables are trained on, and what the fast kernels are tested against.
/// `before`: the band in the frame before, in ranks of this one; empty when there is none. `visit(context,
/// before_class, symbol, step)`.
template <class Visit>
void for_each_symbol(std::span<const std::uint16_t> ranks, std::span<const std::uint16_t> before, int width,
                     Visit visit) {
  const auto columns = static_cast<std::size_t>(width);
  std::vector<std::uint16_t> filled_above(columns + 2, 1);
  std::vector<std::uint16_t> measured_above(columns + 2, 0);
  for (; !ranks.empty(); ranks = ranks.subspan(columns)) {
    std::vector<std::uint16_t> filled(columns + 2);
    std::vector<std::uint16_t> measured(columns + 2);
    int west = filled_above[1];
    int west_west = west;
    int north_west = west;
    bool west_stayed = false;
    for (std::size_t x = 0; x < columns; ++x) {
      const int north = filled_above[x + 1];
      const int predicted = predict(west, north, north_west);
      const int context = context_from_above(&filled_above[x + 1], &measured_above[x + 1]) +
                          context_from_row(west, west_west, north_west, x > 0 && measured[x] != 0);
      const int step = ranks[x] - predicted;
      const int then = before.empty() ? 0 : before[x];
      visit(context, before_class(then, predicted, west_stayed),
            ranks[x] == 0 ? static_cast<int>(kNotMeasured) : kSymbolOf[bounded(step, 7) + 7], step);
      filled[x + 1] = ranks[x] == 0 ? static_cast<std::uint16_t>(predicted) : ranks[x];
      measured[x + 1] = ranks[x];
      west_west = std::exchange(west, filled[x + 1]);
      north_west = north;
      west_stayed = ranks[x] == then;
    }
    filled.front() = filled[1];
    filled.back() = filled[columns];
    if (!before.empty()) before = before.subspan(columns);
    filled_above = std::move(filled);
    measured_above = std::move(measured);
  }
}

}  // namespace telepalp::codec
