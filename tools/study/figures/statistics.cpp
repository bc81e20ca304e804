#include "tools/study/figures/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "haptic_station/device/random.h"
#include "tools/study/figures/shuffle.h"

namespace telepalp::study {
namespace {

constexpr int kResamples = 2000;

std::vector<double> ranks_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t from = 0; from < order.size();) {
    std::size_t to = from;
    while (to < order.size() && values[order[to]] == values[order[from]]) ++to;
    for (std::size_t i = from; i < to; ++i) ranks[order[i]] = 0.5 * static_cast<double>(from + to - 1);
    from = to;
  }
  return ranks;
}

/// Levels of the four factors of a configuration; the last factor changes fastest.
std::array<int, 4> levels_of(std::size_t configuration) {
  std::array<int, 4> levels{};
  auto left = static_cast<int>(configuration);
  for (std::size_t factor = 4; factor-- > 0;) {
    levels[factor] = left % kLevels[factor];
    left /= kLevels[factor];
  }
  return levels;
}

constexpr std::size_t kCells = 36;

/// Index of a configuration's cell in the table of the levels of `factor` and, unless -1, `other`.
std::size_t cell_of(std::size_t configuration, int factor, int other) {
  const std::array<int, 4> levels = levels_of(configuration);
  const auto f = static_cast<std::size_t>(factor);
  if (other < 0) return static_cast<std::size_t>(levels[f]);
  const auto o = static_cast<std::size_t>(other);
  return static_cast<std::size_t>(levels[f] * kLevels[o] + levels[o]);
}

std::size_t cells_of(int factor, int other) {
  const int count =
      kLevels[static_cast<std::size_t>(factor)] * (other < 0 ? 1 : kLevels[static_cast<std::size_t>(other)]);
  return static_cast<std::size_t>(count);
}

std::vector<double> means_of(const Factorial& values, int factor, int other) {
  std::vector<double> sums(cells_of(factor, other), 0.0);
  for (const std::vector<double>& person : values)
    for (std::size_t i = 0; i < kCells; ++i) sums[cell_of(i, factor, other)] += person[i];
  const double in_each = static_cast<double>(values.size() * kCells) / static_cast<double>(sums.size());
  for (double& sum : sums) sum /= in_each;
  return sums;
}

/// Root mean square of an effect. Main effect: of the levels' means about the overall mean. Interaction: of the cells'
/// means after the two main effects are subtracted.
double spread_of(const Factorial& values, int factor, int other) {
  const std::vector<double> means = means_of(values, factor, other);
  const double middle = mean_of(means);
  double sum = 0.0;
  if (other < 0) {
    for (const double mean : means) sum += (mean - middle) * (mean - middle);
  } else {
    const std::vector<double> of_one = means_of(values, factor, -1);
    const std::vector<double> of_other = means_of(values, other, -1);
    for (std::size_t i = 0; i < means.size(); ++i) {
      const double left = means[i] - of_one[i / of_other.size()] - of_other[i % of_other.size()] + middle;
      sum += left * left;
    }
  }
  return std::sqrt(sum / static_cast<double>(means.size()));
}

/// The residuals of the operators' means and the main effects.
Factorial without_main_effects(const Factorial& values) {
  std::array<std::vector<double>, 4> means;
  for (int factor = 0; factor < 4; ++factor) means[static_cast<std::size_t>(factor)] = means_of(values, factor, -1);
  const double middle = mean_of(means[0]);
  Factorial left = values;
  for (std::vector<double>& person : left) {
    const double own = mean_of(person);
    for (std::size_t i = 0; i < kCells; ++i) {
      const std::array<int, 4> levels = levels_of(i);
      person[i] -= own;
      for (std::size_t f = 0; f < 4; ++f) person[i] -= means[f][static_cast<std::size_t>(levels[f])] - middle;
    }
  }
  return left;
}

/// Shuffles the levels of `factor` within each operator and each combination of the other factors.
void shuffle_levels(Factorial& values, int factor, device::Random& random) {
  std::size_t stride = 1;
  for (std::size_t f = static_cast<std::size_t>(factor) + 1; f < 4; ++f) stride *= static_cast<std::size_t>(kLevels[f]);
  const auto count = static_cast<std::size_t>(kLevels[static_cast<std::size_t>(factor)]);
  for (std::vector<double>& person : values)
    for (std::size_t i = 0; i < kCells; ++i) {
      if (levels_of(i)[static_cast<std::size_t>(factor)] != 0) continue;
      std::array<double, 3> line{};
      for (std::size_t k = 0; k < count; ++k) line[k] = person[i + k * stride];
      shuffle(std::span(line).first(count), random);
      for (std::size_t k = 0; k < count; ++k) person[i + k * stride] = line[k];
    }
}

Effect test(const Factorial& values, int factor, int other, int permutations, std::uint64_t seed) {
  device::Random random(seed * 97 + static_cast<std::uint64_t>(factor * 5 + other + 1));
  Effect effect{.factor = factor, .other = other, .means = means_of(values, factor, other)};
  effect.spread = spread_of(values, factor, other);
  Factorial shuffled = other < 0 ? values : without_main_effects(values);
  int as_large = 1;
  for (int i = 0; i < permutations; ++i) {
    if (other < 0)
      shuffle_levels(shuffled, factor, random);
    else
      for (std::vector<double>& person : shuffled) shuffle(std::span(person), random);
    as_large += spread_of(shuffled, factor, other) >= effect.spread * (1.0 - 1e-12) ? 1 : 0;
  }
  effect.p = static_cast<double>(as_large) / (permutations + 1.0);
  return effect;
}

}  // namespace

double mean_of(std::span<const double> values) noexcept {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double rank_correlation(std::span<const double> one, std::span<const double> other) {
  const std::vector<double> a = ranks_of(one);
  const std::vector<double> b = ranks_of(other);
  const double middle = 0.5 * (static_cast<double>(a.size()) - 1.0);
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - middle) * (b[i] - middle);
    aa += (a[i] - middle) * (a[i] - middle);
    bb += (b[i] - middle) * (b[i] - middle);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

Interval bootstrap(std::span<const double> values, std::uint64_t seed) {
  if (values.empty()) return {};
  device::Random random(seed);
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      sum += values[static_cast<std::size_t>(random.uniform() * static_cast<double>(values.size()))];
    mean = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return {mean_of(values), means[kResamples / 40], means[kResamples - 1 - kResamples / 40]};
}

std::string Effect::name() const {
  const std::string one = kFactors[static_cast<std::size_t>(factor)];
  return other < 0 ? one : one + " x " + kFactors[static_cast<std::size_t>(other)];
}

std::vector<Effect> effects_of(const Factorial& values, int permutations, std::uint64_t seed) {
  std::vector<Effect> effects;
  for (int factor = 0; factor < 4; ++factor) effects.push_back(test(values, factor, -1, permutations, seed));
  for (int factor = 0; factor < 4; ++factor)
    for (int other = factor + 1; other < 4; ++other) effects.push_back(test(values, factor, other, permutations, seed));
  return effects;
}

}  // namespace telepalp::study
