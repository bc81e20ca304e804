#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/model/contexts.h"

namespace telepalp::codec {

/// Context and symbol of a pixel (codec/model/contexts.h). `step`: its rank minus the predicted rank.
struct PixelSymbol {
  int context;
  int beyond_class;
  int before_class;
  int symbol;
  int step;
};

/// Calls `visit(PixelSymbol)` for each pixel of a band, with the context and the symbol that the coder uses. It is
/// simple and slow. The training of the tables uses it, and tests compare the fast kernels with it. `before`: the same
/// band of the reference frame, as ranks (palette indices) of this frame; empty without a reference frame.
template <class Visit>
void for_each_symbol(std::span<const std::uint16_t> ranks, std::span<const std::uint16_t> before, int width,
                     Visit visit) {
  const auto columns = static_cast<std::size_t>(width);
  constexpr std::size_t kMargin = 2;
  const std::size_t places = columns + 2 * kMargin;
  std::vector<std::uint16_t> filled_two_above(places, 1);
  std::vector<std::uint16_t> filled_above(places, 1);
  std::vector<std::uint16_t> measured_above(places, 0);
  for (; !ranks.empty(); ranks = ranks.subspan(columns)) {
    std::vector<std::uint16_t> filled(places);
    std::vector<std::uint16_t> measured(places);
    int west = filled_above[kMargin];
    int west_west = west;
    int north_west = west;
    bool west_stayed = false;
    for (std::size_t x = 0; x < columns; ++x) {
      const std::size_t place = x + kMargin;
      const int north = filled_above[place];
      const int predicted = predict(west, north, north_west);
      const int context = context_from_above(&filled_above[place], &measured_above[place]) +
                          context_from_row(west, west_west, north_west, measured[place - 1] != 0);
      const int step = ranks[x] - predicted;
      const int then = before.empty() ? 0 : before[x];
      visit(PixelSymbol{.context = context,
                        .beyond_class = beyond_class(&filled_above[place], &filled_two_above[place]),
                        .before_class = before_class(then, predicted, west_stayed),
                        .symbol = ranks[x] == 0 ? static_cast<int>(kNotMeasured) : kSymbolOf[bounded(step, 7) + 7],
                        .step = step});
      filled[place] = ranks[x] == 0 ? static_cast<std::uint16_t>(predicted) : ranks[x];
      measured[place] = ranks[x];
      west_west = std::exchange(west, filled[place]);
      north_west = north;
      west_stayed = ranks[x] == then;
    }
    for (std::size_t i = 0; i < kMargin; ++i) {
      filled[i] = filled[kMargin];
      filled[places - 1 - i] = filled[places - 1 - kMargin];
    }
    if (!before.empty()) before = before.subspan(columns);
    filled_two_above = std::move(filled_above);
    filled_above = std::move(filled);
    measured_above = std::move(measured);
  }
}

}  // namespace telepalp::codec
