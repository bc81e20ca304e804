// Trains the depth codec's tables and prints codec/depth_tables.cpp: train_depth_tables A.pgm B.pgm … >
// depth_tables.cpp 16-bit binary PGM, as `telepalp-codec decode --to pgm` writes. Contexts whose symbols are alike
// share a model: k-means under relative entropy, which is the bits that sharing costs.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <optional>
#include <string>

#include "codec/level_palette.h"
#include "codec/training/context_statistics.h"

namespace telepalp::codec {
namespace {

constexpr int kClusters = 96;
constexpr int kRounds = 25;
constexpr double kParentWeight = 12.0;  // sightings that the coarser context's word is worth
constexpr double kLeastShare = 1e-4;

using Shares = std::array<double, kSymbols>;
using Counts = std::vector<Shares>;

struct Frame {
  int width = 0;
  std::vector<std::uint16_t> samples;
};

std::optional<Frame> read_pgm(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::string magic;
  int height = 0;
  int most = 0;
  Frame frame;
  if (!(file >> magic >> frame.width >> height >> most) || magic != "P5" || most != 65535) return std::nullopt;
  file.get();
  frame.samples.resize(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(height));
  for (std::uint16_t& sample : frame.samples) {
    const int high = file.get();
    sample = static_cast<std::uint16_t>(high << 8 | file.get());
  }
  if (!file) return std::nullopt;
  return frame;
}

void count(const Frame& frame, Counts& counts) {
  const RankOfLevel rank_of = ranks_of(palette_of(frame.samples));
  std::vector<std::uint16_t> ranks(frame.samples.size());
  std::transform(frame.samples.begin(), frame.samples.end(), ranks.begin(),
                 [&](auto sample) { return rank_of[sample]; });
  for_each_symbol(ranks, frame.width, [&](int context, int symbol, int) {
    counts[static_cast<std::size_t>(context)][static_cast<std::size_t>(symbol)] += 1.0;
  });
}

/// A context with its least telling parts put to their first class; at level 3 only what was measured is left.
std::size_t coarser(std::size_t context, int level) {
  std::array<std::size_t, 4> classes{context % 5, context / 5 % 5, context / 25 % 5, context / 125 % 5};
  if (level >= 1) classes[0] = 0;
  if (level >= 2) classes[2] = 0;
  if (level >= 3) classes[1] = classes[3] = 0;
  return context / 625 * 625 + classes[3] * 125 + classes[2] * 25 + classes[1] * 5 + classes[0];
}

double sum(const Shares& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

/// Shares of each symbol in each context; one seldom seen is told by the coarser ones it is part of.
Counts estimate(const Counts& counts) {
  Shares all{};
  for (const Shares& seen : counts)
    for (std::size_t s = 0; s < all.size(); ++s) all[s] += seen[s];
  const double total = sum(all);
  for (double& share : all) share = (share + 0.01) / (total + 0.01 * kSymbols);
  Counts shares(counts.size(), all);
  for (int level = 3; level >= 0; --level) {
    Counts seen(counts.size());
    for (std::size_t c = 0; c < counts.size(); ++c)
      for (std::size_t s = 0; s < all.size(); ++s) seen[coarser(c, level)][s] += counts[c][s];
    for (std::size_t c = 0; c < counts.size(); ++c) {
      const Shares& told = seen[coarser(c, level)];
      for (std::size_t s = 0; s < all.size(); ++s)
        shares[c][s] = (told[s] + kParentWeight * shares[c][s]) / (sum(told) + kParentWeight);
    }
  }
  return shares;
}

struct Clusters {
  std::vector<std::uint8_t> of;
  std::vector<Shares> shares;
};

Clusters cluster(const Counts& counts, const Counts& shares) {
  std::vector<std::size_t> by_weight(counts.size());
  std::iota(by_weight.begin(), by_weight.end(), std::size_t{0});
  std::stable_sort(by_weight.begin(), by_weight.end(),
                   [&](std::size_t a, std::size_t b) { return sum(counts[a]) > sum(counts[b]); });
  Clusters clusters{.of = std::vector<std::uint8_t>(counts.size()), .shares = {}};
  for (std::size_t k = 0; k < kClusters; ++k) clusters.shares.push_back(shares[by_weight[k]]);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Shares> bits = clusters.shares;
    for (Shares& cost : bits)
      for (double& share : cost) share = -std::log2(share);
    std::vector<Shares> members(kClusters);
    for (std::size_t c = 0; c < counts.size(); ++c) {
      const auto cost = [&](const Shares& b) { return std::inner_product(b.begin(), b.end(), shares[c].begin(), 0.0); };
      const auto best = std::min_element(bits.begin(), bits.end(),
                                         [&](const Shares& a, const Shares& b) { return cost(a) < cost(b); });
      const auto k = static_cast<std::size_t>(best - bits.begin());
      clusters.of[c] = static_cast<std::uint8_t>(k);
      const double weight = sum(counts[c]) + 0.01;
      for (std::size_t s = 0; s < kSymbols; ++s) members[k][s] += weight * shares[c][s];
    }
    for (std::size_t k = 0; k < kClusters; ++k)
      if (const double weight = sum(members[k]); weight > 0.0)
        for (std::size_t s = 0; s < kSymbols; ++s) clusters.shares[k][s] = members[k][s] / weight;
  }
  return clusters;
}

Model model_of(const Shares& shares) {
  const double total = sum(shares) + kSymbols * kLeastShare;
  Model model{};
  double below = 0.0;
  for (std::size_t s = 0; s < kSymbols; ++s) {
    model.cdf[s] =
        static_cast<std::uint16_t>(std::lround(below / total * (kModelTotal - kSymbols)) + static_cast<long>(s));
    below += shares[s] + kLeastShare;
  }
  model.cdf[kSymbols] = kModelTotal;
  return model;
}

void print(const Clusters& clusters) {
  std::printf(
      "// Generated by codec/training/train_depth_tables.cpp; do not edit. See codec/training/README.md for what it "
      "was "
      "trained on.\n\n#include \"codec/depth_tables.h\"\n\n#include <cstdint>\n\nnamespace telepalp::codec "
      "{\nnamespace {\n\n// clang-format "
      "off\nconstexpr std::uint8_t kClusterOf[%d] = {",
      kContexts);
  for (std::size_t c = 0; c < clusters.of.size(); ++c) std::printf("%s%d,", c % 40 == 0 ? "\n" : "", clusters.of[c]);
  std::printf("\n};\n\nconstexpr Model kModels[%d] = {\n", kClusters);
  for (const Shares& shares : clusters.shares) {
    const Model model = model_of(shares);
    std::printf("{{");
    for (const std::uint16_t place : model.cdf) std::printf("%d,", place);
    std::printf("}},\n");
  }
  std::printf(
      "};\n// clang-format on\n\n}  // namespace\n\nconst ContextTables& depth_tables() {\n  static constexpr "
      "ContextTables kTables{kClusterOf, kModels, %d};\n  return kTables;\n}\n\n}  // namespace telepalp::codec\n",
      kClusters);
}

int train(int count_of_files, char** files) {
  Counts counts(kContexts);
  for (int i = 0; i < count_of_files; ++i) {
    const std::optional<Frame> frame = read_pgm(files[i]);
    if (!frame) {
      std::fprintf(stderr, "error: %s: not a 16-bit binary PGM\n", files[i]);
      return 1;
    }
    count(*frame, counts);
  }
  print(cluster(counts, estimate(counts)));
  return 0;
}

}  // namespace
}  // namespace telepalp::codec

int main(int argc, char** argv) { return telepalp::codec::train(argc - 1, argv + 1); }
