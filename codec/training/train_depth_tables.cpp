// Trains the depth codec's tables and prints codec/model/depth_tables.cpp: train_depth_tables A.pgm B.pgm … >
// depth_tables.cpp 16-bit binary PGM, as `telepalp-codec decode --to pgm` writes. Contexts with similar statistics
// share a model. They are clustered by k-means with relative entropy as distance: the number of bits that sharing
// costs.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "codec/levels/level_palette.h"
#include "codec/training/context_statistics.h"

namespace telepalp::codec {
namespace {

constexpr std::size_t kClusters = 160;
constexpr std::size_t kGroups = 255;
constexpr std::size_t kDependentGroups = 96;
constexpr int kRounds = 25;
constexpr double kGroupWeight = 60.0;
constexpr double kParentWeight = 12.0;  // weight of the coarser context's statistics, in symbols
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

/// Calls `visit(PixelSymbol)` for each pixel of a frame. `before`: its reference frame; empty for a key frame.
template <class Visit>
void for_each_of(const Frame& frame, std::span<const std::uint16_t> before, Visit visit) {
  const LevelPalette palette = palette_of(frame.samples);
  const std::vector<std::uint16_t> then =
      before.empty() ? std::vector<std::uint16_t>{} : ranks_by(nearest_ranks_of(palette), before);
  for_each_symbol(ranks_by(ranks_of(palette), frame.samples), then, frame.width, visit);
}

/// Counts symbols in `sets` sets; `place_of(PixelSymbol)` gives the set of a symbol.
template <class Place>
Counts count(const std::vector<Frame>& frames, std::size_t sets, Place place_of) {
  Counts counts(sets);
  for (const Frame& frame : frames)
    for_each_of(frame, {},
                [&](const PixelSymbol& seen) { counts[place_of(seen)][static_cast<std::size_t>(seen.symbol)] += 1.0; });
  return counts;
}

/// A coarser context: the least informative parts are set to their first class. At level 3 only the measured neighbours
/// remain.
std::size_t coarser(std::size_t context, int level) {
  std::array<std::size_t, 4> classes{context % 5, context / 5 % 5, context / 25 % 5, context / 125 % 5};
  if (level >= 1) classes[0] = 0;
  if (level >= 2) classes[2] = 0;
  if (level >= 3) classes[1] = classes[3] = 0;
  return context / 625 * 625 + classes[3] * 125 + classes[2] * 25 + classes[1] * 5 + classes[0];
}

double sum(const Shares& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

/// Share of each symbol in each context. A rare context takes its statistics from the coarser contexts that contain it.
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
      const Shares& coarse = seen[coarser(c, level)];
      for (std::size_t s = 0; s < all.size(); ++s)
        shares[c][s] = (coarse[s] + kParentWeight * shares[c][s]) / (sum(coarse) + kParentWeight);
    }
  }
  return shares;
}

struct Clusters {
  std::vector<std::uint8_t> of;
  std::vector<Shares> shares;
};

Clusters cluster(const Counts& counts, const Counts& shares, std::size_t clusters_wanted) {
  std::vector<std::size_t> by_weight(counts.size());
  std::iota(by_weight.begin(), by_weight.end(), std::size_t{0});
  std::stable_sort(by_weight.begin(), by_weight.end(),
                   [&](std::size_t a, std::size_t b) { return sum(counts[a]) > sum(counts[b]); });
  Clusters clusters{.of = std::vector<std::uint8_t>(counts.size()), .shares = {}};
  for (std::size_t k = 0; k < clusters_wanted; ++k) clusters.shares.push_back(shares[by_weight[k]]);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Shares> bits = clusters.shares;
    for (Shares& cost : bits)
      for (double& share : cost) share = -std::log2(share);
    std::vector<Shares> members(clusters_wanted);
    for (std::size_t c = 0; c < counts.size(); ++c) {
      const auto cost = [&](const Shares& b) { return std::inner_product(b.begin(), b.end(), shares[c].begin(), 0.0); };
      const auto best = std::min_element(bits.begin(), bits.end(),
                                         [&](const Shares& a, const Shares& b) { return cost(a) < cost(b); });
      const auto k = static_cast<std::size_t>(best - bits.begin());
      clusters.of[c] = static_cast<std::uint8_t>(k);
      const double weight = sum(counts[c]) + 0.01;
      for (std::size_t s = 0; s < kSymbols; ++s) members[k][s] += weight * shares[c][s];
    }
    for (std::size_t k = 0; k < clusters_wanted; ++k)
      if (const double weight = sum(members[k]); weight > 0.0)
        for (std::size_t s = 0; s < kSymbols; ++s) clusters.shares[k][s] = members[k][s] / weight;
  }
  return clusters;
}

/// Share of each symbol in each set. A rare set takes its statistics from its cluster.
Counts estimate_beyond(const Counts& counts, const Clusters& clusters) {
  Counts shares(counts.size());
  for (std::size_t place = 0; place < counts.size(); ++place)
    for (std::size_t s = 0; s < kSymbols; ++s)
      shares[place][s] = (counts[place][s] + kParentWeight * clusters.shares[place % kClusters][s]) /
                         (sum(counts[place]) + kParentWeight);
  return shares;
}

/// The set in which a symbol counts once contexts are clustered.
std::size_t place_of(const PixelSymbol& seen, const Clusters& clusters) {
  return static_cast<std::size_t>(seen.beyond_class) * kClusters + clusters.of[static_cast<std::size_t>(seen.context)];
}

/// Models of dependent frames, kBeforeClasses for each group. A rare model takes its statistics from its group.
std::vector<Shares> dependent_models(const Clusters& clusters, const Clusters& groups,
                                     const std::vector<Frame>& sequence) {
  std::vector<Shares> models;
  for (const Shares& shares : groups.shares)
    for (int i = 0; i < kBeforeClasses; ++i) {
      models.push_back(shares);
      for (double& share : models.back()) share *= kGroupWeight;
    }
  for (std::size_t i = 1; i < sequence.size(); ++i)
    for_each_of(sequence[i], sequence[i - 1].samples, [&](const PixelSymbol& seen) {
      const std::size_t group = groups.of[place_of(seen, clusters)];
      models[group * kBeforeClasses + static_cast<std::size_t>(seen.before_class)]
            [static_cast<std::size_t>(seen.symbol)] += 1.0;
    });
  for (Shares& shares : models) {
    const double total = sum(shares);
    for (double& share : shares) share /= total;
  }
  return models;
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

void print_front() {
  std::puts(
      "// Generated by codec/training/train_depth_tables.cpp; do not edit. See codec/training/README.md for what it "
      "was\n"
      "// trained on.\n\n#include \"codec/model/depth_tables.h\"\n\n#include <cstdint>\n#include <iterator>\n#include "
      "<vector>\n\nnamespace telepalp::codec {\n"
      "namespace {\n\n// clang-format off");
}

void print(const char* name, const std::vector<std::uint8_t>& numbers) {
  std::printf("constexpr std::uint8_t k%s[%zu] = {", name, numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) std::printf("%s%d,", i % 40 == 0 ? "\n" : "", numbers[i]);
  std::puts("\n};");
}

void print(const char* name, const std::vector<Shares>& models) {
  std::printf("constexpr Model k%s[%zu] = {\n", name, models.size());
  for (const Shares& shares : models) {
    std::printf("{{");
    for (const std::uint16_t place : model_of(shares).cdf) std::printf("%d,", place);
    std::printf("}},\n");
  }
  std::puts("};\n");
}

void print_back() {
  std::printf(
      "// clang-format on\n\n"
      "/// The group of each context for each of kBeyondClasses. Spread out, so that the coder looks up once.\n"
      "std::vector<std::uint8_t> spread(const std::uint8_t* group_of) {\n"
      "  std::vector<std::uint8_t> groups;\n"
      "  groups.reserve(std::size_t{kBeyondClasses} * kContexts);\n"
      "  for (int beyond = 0; beyond < kBeyondClasses; ++beyond)\n"
      "    for (const std::uint8_t cluster : kClusterOf) groups.push_back(group_of[beyond * %zu + cluster]);\n"
      "  return groups;\n"
      "}\n\n}  // namespace\n\n",
      kClusters);
  for (const auto& [function, name] : {std::pair{"depth_tables", "Still"}, {"dependent_depth_tables", "Dependent"}})
    std::printf(
        "const ContextTables& %s() {\n"
        "  static const std::vector<std::uint8_t> groups = spread(k%sGroupOf);\n"
        "  static const ContextTables tables{groups.data(), k%sModels, std::size(k%sModels)};\n  return tables;\n}\n\n",
        function, name, name, name);
  std::puts("}  // namespace telepalp::codec");
}

int train(std::span<char*> files) {
  std::vector<Frame> stills;
  std::vector<Frame> sequence;
  bool in_sequence = false;
  for (const std::string file : files) {
    if (file == "--") {
      in_sequence = true;
      continue;
    }
    std::optional<Frame> frame = read_pgm(file.c_str());
    if (!frame) {
      std::fprintf(stderr,
                   "error: %s: cannot be read as a 16-bit binary PGM. fix: give files of the format P5 whose largest "
                   "value is 65535\n",
                   file.c_str());
      return 1;
    }
    (in_sequence ? sequence : stills).push_back(std::move(*frame));
  }
  const Counts counts =
      count(stills, kContexts, [](const PixelSymbol& seen) { return static_cast<std::size_t>(seen.context); });
  const Clusters clusters = cluster(counts, estimate(counts), kClusters);
  const Counts counts_beyond =
      count(stills, kBeyondClasses * kClusters, [&](const PixelSymbol& seen) { return place_of(seen, clusters); });
  const Counts shares_beyond = estimate_beyond(counts_beyond, clusters);
  const Clusters still = cluster(counts_beyond, shares_beyond, kGroups);
  const Clusters dependent = cluster(counts_beyond, shares_beyond, kDependentGroups);
  print_front();
  print("ClusterOf", clusters.of);
  print("StillGroupOf", still.of);
  print("StillModels", still.shares);
  print("DependentGroupOf", dependent.of);
  print("DependentModels", dependent_models(clusters, dependent, sequence));
  print_back();
  return 0;
}

}  // namespace
}  // namespace telepalp::codec

int main(int argc, char** argv) {
  return telepalp::codec::train(std::span(argv + 1, static_cast<std::size_t>(argc - 1)));
}
