#include "codec/fast/rank_wavefront.h"

#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace telepalp::codec {
namespace {

/// One rank per row. Additions use the unsigned `Sums`, because damaged ranks may overflow.
using Ranks [[gnu::vector_size(16)]] = std::int16_t;
using Sums [[gnu::vector_size(16)]] = std::uint16_t;
static_assert(sizeof(Ranks) == RankWavefront::kRows * sizeof(std::int16_t));

Ranks sum(Ranks a, Ranks b) noexcept {
  return reinterpret_cast<Ranks>(reinterpret_cast<Sums>(a) + reinterpret_cast<Sums>(b));
}
Ranks difference(Ranks a, Ranks b) noexcept {
  return reinterpret_cast<Ranks>(reinterpret_cast<Sums>(a) - reinterpret_cast<Sums>(b));
}
Ranks least(Ranks a, Ranks b) noexcept { return a < b ? a : b; }
Ranks greatest(Ranks a, Ranks b) noexcept { return a > b ? a : b; }

/// The northern neighbours of the eight current pixels: `of_first` for the first row, the row above for the others.
Ranks north_of(Ranks ranks, std::int16_t of_first) noexcept {
#if defined(__SSE2__)  // two instructions; without intrinsics GCC needs thirty
  return reinterpret_cast<Ranks>(_mm_insert_epi16(_mm_slli_si128(reinterpret_cast<__m128i>(ranks), 2), of_first, 0));
#else
  return __builtin_shufflevector(ranks, Ranks{of_first}, 8, 0, 1, 2, 3, 4, 5, 6);
#endif
}

}  // namespace

std::uint16_t RankWavefront::advance() noexcept {
  ranks_.swap(above_);
  Ranks west{};
  Ranks north_west{};
  Ranks highest{};
  for (std::size_t step = 0; step < width_ + kRows - 1; ++step) {
    Ranks change;
    std::memcpy(&change, &changes_[step * kRows], sizeof change);
    const Ranks north = north_of(west, above_[place(kRows - 1, step)]);
    const Ranks slope = sum(west, difference(north, north_west));
    const Ranks predicted = greatest(least(west, north), least(greatest(west, north), slope));
    const Ranks ranks = greatest(sum(predicted, change), Ranks{});
    std::memcpy(&ranks_[step * kRows], &ranks, sizeof ranks);
    highest = greatest(highest, ranks);
    west = ranks;
    north_west = north;
  }
  std::memset(changes_.data(), 0, changes_.size() * sizeof changes_[0]);
  std::int16_t most = 0;
  for (std::size_t row = 0; row < kRows; ++row) most = highest[row] > most ? highest[row] : most;
  return static_cast<std::uint16_t>(most);
}

}  // namespace telepalp::codec
