#include "codec/bounded/reconstruction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <utility>

#include "codec/stream/frame_coding.h"
#include "tests/codec/depth_frames.h"

namespace telepalp::codec {
namespace {

TEST(DepthBound, HoldsForEveryPossibleSample) {
  DepthImage all{.width = 256, .height = 256, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(65536)};
  std::iota(all.samples.begin(), all.samples.end(), std::uint16_t{0});
  for (const DepthErrorBound& bound :
       {kOneDisparityStep, DepthErrorBound{.least_m = 0.0, .per_m = 0.0}, DepthErrorBound{.least_m = 100.0}}) {
    for (const DepthImage& key : {kinect_like(96, 200, 1), all, filled(8, 8, 0)}) {
      ReconstructionLevels reconstruction = reconstruction_levels_for(key, palette_of(key.samples), bound);
      const RankedFrame frame = within_bounds(all, palette_of(all.samples), reconstruction);
      EXPECT_EQ(frame.ranks[0], 0);
      EXPECT_EQ(frame.most[0], 65535);
      for (std::size_t sample = 1; sample < all.samples.size(); ++sample) {
        ASSERT_LE(frame.ranks[sample], frame.most[sample]) << sample;
        ASSERT_GT(frame.ranks[sample], 0) << sample;
        for (const std::uint16_t rank : {frame.ranks[sample], frame.most[sample]}) {
          const double error_m = std::abs(frame.palette.levels[rank] - static_cast<double>(sample)) * all.unit_m;
          ASSERT_LE(error_m, bound.at(static_cast<double>(sample) * all.unit_m) + 1e-9) << sample;
        }
      }
    }
  }
}

using Range = std::pair<int, int>;

bool any_within(const std::vector<int>& values, int from, int to) {
  return std::any_of(values.begin(), values.end(), [&](int value) { return from <= value && value <= to; });
}

/// Cost of a set of reconstruction levels: one for each level in the set, and one for each pair of neighbours that
/// could have shared a level but cannot. nullopt when some level has none within its bound.
std::optional<std::int64_t> cost_of(const std::vector<int>& set, const std::vector<Range>& levels,
                                    const std::vector<int>& next_to) {
  auto cost = static_cast<std::int64_t>(set.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (!any_within(set, levels[i].first, levels[i].second)) return std::nullopt;
    if (i + 1 == levels.size() || levels[i + 1].first > levels[i].second) continue;
    if (!any_within(set, levels[i + 1].first, levels[i].second)) cost += next_to[i];
  }
  return cost;
}

/// The least cost of any set, by exhaustive search: slow but certain.
std::int64_t least_cost(const std::vector<Range>& levels, const std::vector<int>& next_to) {
  std::vector<int> ends;
  for (const Range& level : levels) ends.insert(ends.end(), {level.first, level.second});
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (unsigned members = 1; members < 1U << ends.size(); ++members) {
    std::vector<int> set;
    for (std::size_t i = 0; i < ends.size(); ++i)
      if ((members >> i & 1) != 0) set.push_back(ends[i]);
    least = std::min(least, cost_of(set, levels, next_to).value_or(least));
  }
  return least;
}

TEST(DepthBound, ReconstructionLevelsSeparateAsFewNeighboursAsPossible) {
  constexpr int kBound = 6;
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    std::vector<Range> levels;
    std::vector<int> next_to;
    DepthImage depth{.width = 2, .height = 0, .unit_m = 0.001, .samples = {}};
    for (int level = 1000; levels.size() < 6; level += 1 + static_cast<int>(random() % 12)) {
      if (!levels.empty()) {
        next_to.push_back(1 + static_cast<int>(random() % 5));
        const auto before = static_cast<std::uint16_t>(levels.back().first + kBound);
        for (int n = 0; n < next_to.back();
             ++n, depth.height += 2)  // each pair in its own row, followed by a row of holes
          depth.samples.insert(depth.samples.end(), {before, static_cast<std::uint16_t>(level), 0, 0});
      }
      levels.emplace_back(level - kBound, level + kBound);
    }
    const ReconstructionLevels reconstruction =
        reconstruction_levels_for(depth, palette_of(depth.samples), {.least_m = 0.001 * kBound, .per_m = 0.0});
    const std::vector<std::uint16_t>& found = reconstruction.levels.levels;
    EXPECT_EQ(cost_of({found.begin() + 1, found.end()}, levels, next_to), least_cost(levels, next_to)) << round;
  }
}

/// The frame after encoding and decoding by Bounded.
DepthImage moved(const DepthImage& depth) {
  const LevelPalette palette = palette_of(depth.samples);
  ReconstructionLevels reconstruction = reconstruction_levels_for(depth, palette, kOneDisparityStep);
  return code_bounded(depth, palette, reconstruction, {}).depth;
}

TEST(DepthBound, DepthsThatCanShareNoLevelAreUnchanged) {
  DepthImage depth = filled(64, 48, 0);
  for (std::size_t i = 0; i < depth.samples.size(); ++i)
    depth.samples[i] = static_cast<std::uint16_t>(i % 9 == 0 ? 0 : 1000 + 100 * (i / 7 % 20));
  EXPECT_EQ(moved(depth).samples, depth.samples);
}

TEST(DepthBound, ReconstructionLevelsAreUnbiased) {
  const DepthImage depth = kinect_like(320, 240, 5);
  const LevelPalette palette = palette_of(depth.samples);
  ReconstructionLevels reconstruction = reconstruction_levels_for(depth, palette, kOneDisparityStep);
  const RankedFrame frame = within_bounds(depth, palette, reconstruction);
  double sum_in_bounds = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < depth.samples.size(); ++i) {
    if (depth.samples[i] == 0) continue;
    const double middle = 0.5 * (frame.palette.levels[frame.ranks[i]] + frame.palette.levels[frame.most[i]]);
    sum_in_bounds += (middle - depth.samples[i]) * depth.unit_m / kOneDisparityStep.at(depth.samples[i] * depth.unit_m);
    count += 1.0;
  }
  EXPECT_LT(std::abs(sum_in_bounds / count), 0.05);
}

/// The frame with each level replaced by its nearest reconstruction level, to compare with the encoder's choice.
DepthImage by_nearest(const DepthImage& depth, const ReconstructionLevels& reconstruction) {
  DepthImage moved = depth;
  const RankOfLevel nearest = nearest_ranks_of(reconstruction.levels);
  for (std::uint16_t& sample : moved.samples) sample = reconstruction.levels.levels[nearest[sample]];
  return moved;
}

TEST(DepthBound, ChoosingWhatIsLikelyTakesFewerBytesThanTheNearest) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const DepthImage depth = kinect_like(320, 240, seed);
    const LevelPalette palette = palette_of(depth.samples);
    ReconstructionLevels reconstruction = reconstruction_levels_for(depth, palette, kOneDisparityStep);
    const std::size_t nearest = write_frame(by_nearest(depth, reconstruction), DepthMode::Bounded, {}).bytes.size();
    EXPECT_LT(code_bounded(depth, palette, reconstruction, {}).packet.bytes.size(), nearest * 9 / 10);
  }
}

}  // namespace
}  // namespace telepalp::codec
