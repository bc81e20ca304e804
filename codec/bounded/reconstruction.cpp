#include "codec/bounded/reconstruction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "codec/levels/level_palette.h"

namespace telepalp::codec {
namespace {

constexpr int kSamples = 65536;
constexpr int kMostAcross = 6;                 // largest rank difference that is counted by itself
constexpr std::size_t kPixelsPerLevel = 1024;  // one level costs as much as one unequal neighbour per so many pixels
constexpr std::size_t kRowsPerCounted = 2;

/// For each rank, how many neighbour pairs differ by 0, 1, … kMostAcross ranks; the last entry counts larger
/// differences, which are edges and cost the same with any reconstruction levels. Every other row is counted. The
/// entries of rank 0 (holes) have no meaning.
using LevelNeighbours = std::vector<std::array<std::int32_t, kMostAcross + 2>>;

LevelNeighbours neighbours_of(const DepthImage& depth, const LevelPalette& palette) {
  const RankOfLevel rank_of = ranks_of(palette);
  LevelNeighbours neighbours(palette.size());
  const auto count = [&](std::uint16_t a, std::uint16_t b) {  // without a branch: it would be mispredicted
    ++neighbours[std::min(a, b)][static_cast<std::size_t>(std::min(std::abs(a - b), kMostAcross + 1))];
  };
  const auto width = static_cast<std::size_t>(depth.width);
  for (std::size_t row = 0; row < depth.samples.size(); row += kRowsPerCounted * width) {
    std::uint16_t west = 0;
    for (std::size_t i = row; i < row + width; ++i) {
      const std::uint16_t rank = rank_of[depth.samples[i]];
      count(std::exchange(west, rank), rank);
      if (row >= width) count(rank_of[depth.samples[i - width]], rank);
    }
  }
  return neighbours;
}

/// The frame's levels, ascending and without 0, each with the range of depths within its error bound.
struct Reach {
  std::vector<int> level;
  std::vector<int> nearest;
  std::vector<int> farthest;
};

Reach reach_of(const LevelPalette& palette, const BoundInUnits& bound_at) {
  Reach reach;
  for (std::size_t rank = 1; rank < palette.size(); ++rank) {
    const int level = palette.levels[rank];
    const int bound = bound_at(level);
    reach.level.push_back(level);
    reach.nearest.push_back(std::max(1, level - bound));
    reach.farthest.push_back(std::min(kSamples - 1, level + bound));
  }
  return reach;
}

/// Counts the neighbour pairs that the cut between `from` and `first_apart` separates although their bounds overlap.
std::int64_t parted(const Reach& reach, const LevelNeighbours& neighbours, std::size_t from, std::size_t first_apart) {
  std::int64_t sum = 0;
  for (std::size_t across = first_apart - from; across <= std::size_t{kMostAcross}; ++across) {
    const std::size_t to = from + across;
    if (to >= reach.nearest.size() || reach.nearest[to] > reach.farthest[from]) break;
    sum += neighbours[from + 1][across];
  }
  return sum;
}

/// Chooses levels by dynamic programming. Candidates are the farthest depths of the levels' bounds, which suffice:
/// every level must have a chosen candidate within its bound. The cost is the number of separated neighbour pairs plus
/// `level_cost` for each chosen candidate. Returns indices into `reach`.
std::vector<std::size_t> best_depths(const Reach& reach, const LevelNeighbours& neighbours, std::int64_t level_cost) {
  const std::size_t count = reach.nearest.size();
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::int64_t> cost(count, kNever);
  std::vector<std::size_t> before(count, kNone);
  if (count > 0) cost[0] = level_cost;
  std::size_t unreachable = 0;  // first level that cannot take the current candidate
  std::size_t best_last = kNone;
  for (std::size_t last = 0; last < count; ++last) {
    while (unreachable < count && reach.nearest[unreachable] <= reach.farthest[last]) ++unreachable;
    if (cost[last] == kNever) continue;
    if (unreachable == count && (best_last == kNone || cost[last] < cost[best_last])) best_last = last;
    std::int64_t with_next = cost[last] + level_cost;
    const std::size_t first_parting =
        unreachable - std::min(unreachable, kMostAcross + std::size_t{1});  // earlier candidates separate no pairs
    for (std::size_t next = std::max(last + 1, first_parting); next <= std::min(unreachable, count - 1); ++next) {
      if (with_next < cost[next]) {
        cost[next] = with_next;
        before[next] = last;
      }
      with_next += parted(reach, neighbours, next, unreachable);
    }
  }
  std::vector<std::size_t> farthest_of;
  for (std::size_t i = best_last; i != kNone; i = before[i]) farthest_of.push_back(i);
  std::reverse(farthest_of.begin(), farthest_of.end());
  return farthest_of;
}

/// Centres a chosen candidate among the levels that can take it, as far as their bounds allow, so that errors are small
/// and balanced.
int centred(const Reach& reach, std::size_t farthest_of) {
  const int farthest = reach.farthest[farthest_of];
  const auto past_last = std::upper_bound(reach.nearest.begin(), reach.nearest.end(), farthest);
  const auto last = static_cast<std::size_t>(past_last - reach.nearest.begin()) - 1;
  const int twice = reach.level[farthest_of] + reach.level[last];
  const int middle = twice / 2 + (twice / 2 & twice &
                                  1);  // round half to even: rounding down would bias all levels towards the camera
  return std::clamp(middle, reach.nearest[last], farthest);
}

/// Adds a reconstruction level for each level of the frame that has none within its bound.
void complete(ReconstructionLevels& reconstruction, const LevelPalette& present) {
  std::vector<std::uint16_t>& levels = reconstruction.levels.levels;
  auto next = levels.begin() + 1;  // first reconstruction level that is not too near
  for (std::size_t rank = 1; rank < present.size(); ++rank) {
    const int level = present.levels[rank];
    const int bound = reconstruction.bound(level);
    while (next != levels.end() && *next < level - bound) ++next;
    if (next == levels.end() || *next > level + bound)
      next = levels.insert(next, static_cast<std::uint16_t>(std::min(kSamples - 1, level + bound)));
  }
}

/// For each level of a frame, its nearest and its farthest allowed reconstruction level, as indices.
struct Choice {
  std::vector<std::size_t> least;
  std::vector<std::size_t> most;
};

Choice choice_of(const LevelPalette& present, const LevelPalette& reconstruction, const BoundInUnits& bound_at) {
  Choice choice{.least = {0}, .most = {0}};
  const std::vector<std::uint16_t>& levels = reconstruction.levels;
  std::size_t least = 1;
  std::size_t most = 0;
  for (std::size_t rank = 1; rank < present.size(); ++rank) {
    const int level = present.levels[rank];
    const int bound = bound_at(level);
    while (levels[least] < level - bound) ++least;
    while (most + 1 < levels.size() && levels[most + 1] <= level + bound) ++most;
    choice.least.push_back(least);
    choice.most.push_back(most);
  }
  return choice;
}

/// Puts the reconstruction levels that some level may take into `palette`, and returns the rank of each.
std::vector<std::uint16_t> rank_those_of(const Choice& choice, const LevelPalette& reconstruction,
                                         LevelPalette& palette) {
  std::vector<std::uint16_t> rank_of(reconstruction.levels.size());
  std::size_t next = 1;
  for (std::size_t i = 1; i < choice.least.size(); ++i)
    for (next = std::max(next, choice.least[i]); next <= choice.most[i]; ++next) {
      rank_of[next] = static_cast<std::uint16_t>(palette.size());
      palette.levels.push_back(reconstruction.levels[next]);
    }
  return rank_of;
}

/// Least rank (low half) and greatest rank (high half) of each level of a frame. Those of level 0, "not measured", are
/// 0 and 0xffff.
std::vector<std::uint32_t> packed_ranks(const Choice& choice, const std::vector<std::uint16_t>& rank_of) {
  std::vector<std::uint32_t> ranks{0xffff0000};
  for (std::size_t i = 1; i < choice.least.size(); ++i)
    ranks.push_back(std::uint32_t{rank_of[choice.most[i]]} << 16 | rank_of[choice.least[i]]);
  return ranks;
}

/// packed_ranks() of ring 0, ring 1, and so on, in one table. Fills `palette` with the levels that they refer to.
std::vector<std::uint32_t> packed_ranks_of_rings(const LevelPalette& present,
                                                 const ReconstructionLevels& reconstruction, const DepthWindow& window,
                                                 LevelPalette& palette) {
  const auto choice_in = [&](int ring) {
    return choice_of(present, reconstruction.levels, {window.in_ring(ring), reconstruction.bound.unit_m});
  };
  // The outermost ring has the largest bound, so its pixels may take each level that an inner ring's may.
  const std::vector<std::uint16_t> rank_of =
      rank_those_of(choice_in(DepthWindow::kRings - 1), reconstruction.levels, palette);
  std::vector<std::uint32_t> ranks;
  for (int ring = 0; ring < DepthWindow::kRings; ++ring) {
    const std::vector<std::uint32_t> of_ring = packed_ranks(choice_in(ring), rank_of);
    ranks.insert(ranks.end(), of_ring.begin(), of_ring.end());
  }
  return ranks;
}

/// For each place on an axis: the first index of its ring in a table with `count` entries for each ring. 0 for places
/// in the window, so that the greater of a pixel's two offsets is that of its ring.
std::vector<std::size_t> ring_offsets(int exact_first, int exact_size, int size, std::size_t count) {
  std::vector<std::size_t> offsets;
  for (int at = 0; at < size; ++at)
    offsets.push_back(count * static_cast<std::size_t>(std::max(0, ring_on_axis(at, exact_first, exact_size, size))));
  return offsets;
}

}  // namespace

int BoundInUnits::operator()(int sample) const noexcept {
  return static_cast<int>(std::min(std::floor(bound.at(sample * unit_m) / unit_m + 1e-9), double{kSamples}));
}

ReconstructionLevels reconstruction_levels_for(const DepthImage& depth, const LevelPalette& palette,
                                               const DepthErrorBound& bound) {
  ReconstructionLevels reconstruction{.levels = {}, .bound = {bound, depth.unit_m}};
  const Reach reach = reach_of(palette, reconstruction.bound);
  const auto level_cost = static_cast<std::int64_t>(depth.samples.size() / (kPixelsPerLevel * kRowsPerCounted) + 1);
  for (const std::size_t farthest_of : best_depths(reach, neighbours_of(depth, palette), level_cost))
    reconstruction.levels.levels.push_back(static_cast<std::uint16_t>(centred(reach, farthest_of)));
  return reconstruction;
}

RankedFrame within_bounds(const DepthImage& depth, const LevelPalette& present, ReconstructionLevels& reconstruction) {
  complete(reconstruction, present);
  const Choice choice = choice_of(present, reconstruction.levels, reconstruction.bound);
  RankedFrame frame;
  const std::vector<std::uint16_t> rank_of = rank_those_of(choice, reconstruction.levels, frame.palette);
  const std::vector<std::uint32_t> ranks_of_level = packed_ranks(choice, rank_of);
  std::vector<std::uint32_t> ranks_of_sample(kSamples);  // one look-up for both ranks
  for (std::size_t i = 0; i < present.size(); ++i) ranks_of_sample[present.levels[i]] = ranks_of_level[i];
  frame.ranks.resize(depth.samples.size());
  frame.most.resize(depth.samples.size());
  for (std::size_t i = 0; i < depth.samples.size(); ++i) {
    const std::uint32_t ranks = ranks_of_sample[depth.samples[i]];
    frame.ranks[i] = static_cast<std::uint16_t>(ranks);
    frame.most[i] = static_cast<std::uint16_t>(ranks >> 16);
  }
  return frame;
}

RankedFrame within_window(const DepthImage& outer, const LevelPalette& present, ReconstructionLevels& reconstruction,
                          const DepthWindow& window) {
  reconstruction.bound.bound = window.near;
  complete(reconstruction, present);
  RankedFrame frame;
  const std::vector<std::uint32_t> packed = packed_ranks_of_rings(present, reconstruction, window, frame.palette);
  const RankOfLevel rank_of = ranks_of(present);
  const PixelRect& exact = window.exact;
  const auto of_column = ring_offsets(exact.column, exact.width, outer.width, present.size());
  const auto of_row = ring_offsets(exact.row, exact.height, outer.height, present.size());
  frame.ranks.resize(outer.samples.size());
  frame.most.resize(outer.samples.size());
  std::size_t i = 0;
  for (const std::size_t row : of_row)
    for (const std::size_t column : of_column) {
      const std::uint32_t ranks = packed[std::max(row, column) + rank_of[outer.samples[i]]];
      frame.ranks[i] = static_cast<std::uint16_t>(ranks);
      frame.most[i++] = static_cast<std::uint16_t>(ranks >> 16);
    }
  return frame;
}

}  // namespace telepalp::codec
