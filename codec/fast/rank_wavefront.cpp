#include "codec/fast/rank_wavefront.h"

#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace telepalp::codec {
namespace {

/// One rank per row. Additions use the unsigned `Sums`, because damaged ranks may overflow.
using EightRanks [[gnu::vector_size(16)]] = std::int16_t;
using Sums [[gnu::vector_size(16)]] = std::uint16_t;
static_assert(sizeof(EightRanks) == RankWavefront::kRows * sizeof(std::int16_t));

EightRanks sum(EightRanks a, EightRanks b) noexcept {
  return reinterpret_cast<EightRanks>(reinterpret_cast<Sums>(a) + reinterpret_cast<Sums>(b));
}
EightRanks difference(EightRanks a, EightRanks b) noexcept {
  return reinterpret_cast<EightRanks>(reinterpret_cast<Sums>(a) - reinterpret_cast<Sums>(b));
}
EightRanks least(EightRanks a, EightRanks b) noexcept { return a < b ? a : b; }
EightRanks greatest(EightRanks a, EightRanks b) noexcept { return a > b ? a : b; }

/// The northern neighbours of the eight current pixels: `of_first` for the first row, the row above for the others.
EightRanks north_of(EightRanks ranks, std::int16_t of_first) noexcept {
#if defined(__SSE2__)  // two instructions; without intrinsics GCC needs thirty
  return reinterpret_cast<EightRanks>(
      _mm_insert_epi16(_mm_slli_si128(reinterpret_cast<__m128i>(ranks), 2), of_first, 0));
#else
  return __builtin_shufflevector(ranks, EightRanks{of_first}, 8, 0, 1, 2, 3, 4, 5, 6);
#endif
}

}  // namespace

std::uint16_t RankWavefront::advance() noexcept {
  ranks_.swap(above_);
  EightRanks west{};
  EightRanks north_west{};
  EightRanks highest{};
  for (std::size_t step = 0; step < width_ + kRows - 1; ++step) {
    EightRanks change;
    std::memcpy(&change, &changes_[step * kRows], sizeof change);
    const EightRanks north = north_of(west, above_[place(kRows - 1, step)]);
    const EightRanks slope = sum(west, difference(north, north_west));
    const EightRanks predicted = greatest(least(west, north), least(greatest(west, north), slope));
    const EightRanks ranks = greatest(sum(predicted, change), EightRanks{});
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
