#include "codec/depth_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

#include "codec/level_palette.h"

namespace telepalp::codec {
namespace {

constexpr int kSamples = 65536;
constexpr int kMostAcross = 6;  // ranks

/// The bound at each sample, in whole units.
std::vector<int> bounds_of(const DepthBound& bound, double unit_m) {
  std::vector<int> bounds(kSamples);
  for (int sample = 1; sample < kSamples; ++sample)
    bounds[static_cast<std::size_t>(sample)] =
        static_cast<int>(std::min(std::floor(bound.at(sample * unit_m) / unit_m + 1e-9), double{kSamples}));
  return bounds;
}

/// How often neighbouring pixels lie on either side of the step from each rank to the next: what a boundary there
/// costs. Pixels further apart than kMostAcross lie on either side of an edge, which is dear wherever boundaries are.
std::vector<std::int64_t> crossings(const LevelPalette& palette, const DepthImage& depth) {
  const std::vector<std::uint16_t> ranks = ranks_by(ranks_of(palette), depth.samples);
  std::vector<std::int64_t> starts(palette.size() + 1);  // less those that end
  const auto count = [&](std::uint16_t a, std::uint16_t b) {
    if (a == b || a == 0 || b == 0 || std::abs(a - b) > kMostAcross) return;
    ++starts[std::min(a, b)];
    --starts[std::max(a, b)];
  };
  const auto width = static_cast<std::size_t>(depth.width);
  for (std::size_t i = 1; i < ranks.size(); ++i) {
    count(ranks[i - 1], ranks[i]);
    if (i >= width) count(ranks[i - width], ranks[i]);
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

/// Values that stand within the bound of every level, each for a run of levels: of all ways to part the levels into
/// runs the one that parts the fewest neighbouring pixels. Least cost by dynamic programming over the run's last level.
std::vector<int> stand_ins(const LevelPalette& palette, const std::vector<int>& bounds,
                           const std::vector<std::int64_t>& crossed) {
  const auto level = [&](std::size_t rank) { return int{palette.levels[rank]}; };
  const auto bound = [&](std::size_t rank) { return bounds[palette.levels[rank]]; };
  std::vector<std::int64_t> cost(palette.size(), 0);
  std::vector<std::size_t> first_of(palette.size(), 0);
  for (std::size_t last = 1; last < palette.size(); ++last) {
    cost[last] = std::numeric_limits<std::int64_t>::max();
    for (std::size_t first = last; first >= 1; --first) {
      if (level(last) - bound(last) > std::min(kSamples - 1, level(first) + bound(first))) break;
      const std::int64_t with_run = cost[first - 1] + (first > 1 ? crossed[first - 1] + 1 : 0);
      if (with_run >= cost[last]) continue;
      cost[last] = with_run;
      first_of[last] = first;
    }
  }
  std::vector<int> values;
  for (std::size_t last = palette.size() - 1; last >= 1; last = first_of[last] - 1) {
    const std::size_t first = first_of[last];
    const int farthest = std::min(kSamples - 1, level(first) + bound(first));
    const int nearest = std::max(1, level(last) - bound(last));
    values.push_back(std::clamp((level(first) + level(last)) / 2, std::min(nearest, farthest), farthest));
  }
  std::reverse(values.begin(), values.end());
  return values;
}

}  // namespace

double DepthBound::at(double z_m) const noexcept { return std::max(least_m, per_m * z_m * z_m); }

LevelMap bounded_levels(const DepthImage& depth, const DepthBound& bound) {
  const LevelPalette palette = palette_of(depth.samples);
  const std::vector<int> bounds = bounds_of(bound, depth.unit_m);
  const std::vector<int> values = stand_ins(palette, bounds, crossings(palette, depth));
  LevelMap map(kSamples);
  std::size_t i = 0;
  int between = -2 * kSamples;  // a value for samples that this frame does not have, and a later one may
  for (int sample = 1; sample < kSamples; ++sample) {
    const int allowed = bounds[static_cast<std::size_t>(sample)];
    const auto distance = [&](int value) { return std::abs(value - sample); };
    while (i + 1 < values.size() && distance(values[i + 1]) <= distance(values[i])) ++i;
    const bool stands_in = !values.empty() && distance(values[i]) <= allowed;
    if (!stands_in && distance(between) > allowed) between = std::min(kSamples - 1, sample + allowed);
    map[static_cast<std::size_t>(sample)] = static_cast<std::uint16_t>(stands_in ? values[i] : between);
  }
  return map;
}

DepthImage with_levels(const DepthImage& depth, const LevelMap& map) {
  DepthImage mapped = depth;
  for (std::uint16_t& sample : mapped.samples) sample = map[sample];
  return mapped;
}

}  // namespace telepalp::codec
