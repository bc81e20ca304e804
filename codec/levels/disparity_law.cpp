#include "codec/levels/disparity_law.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace telepalp::codec {
namespace {

constexpr std::size_t kFewest = 16;
constexpr std::size_t kMost = 4096;
constexpr int kRounds = 4;
constexpr double kUnit = 1e9;  // about the inverse at 1 m, so that weights are near 1

/// Inverse depth as a linear function of the step. Only the encoder needs it.
struct Line {
  double farthest = 0.0;
  double step = 0.0;
};

/// Weighted least squares of 1/z over `steps`. The rounding of z makes 1/z uncertain in proportion to 1/z².
Line fit_line(std::span<const double> inverses, std::span<const double> steps) {
  double w = 0.0, wn = 0.0, wnn = 0.0, wi = 0.0, wni = 0.0;
  for (std::size_t i = 0; i < inverses.size(); ++i) {
    const double certainty = kUnit / inverses[i];
    const double weight = certainty * certainty * certainty * certainty;
    w += weight;
    wn += weight * steps[i];
    wnn += weight * steps[i] * steps[i];
    wi += weight * inverses[i];
    wni += weight * steps[i] * inverses[i];
  }
  const double slope = (w * wni - wn * wi) / (w * wnn - wn * wn);
  return {(wi - slope * wn) / w, slope};
}

/// Fits a line to ascending `inverses`, the farthest level first. Starting with a guess of the step's size, it
/// alternates between numbering the levels and fitting the size. The far levels are fitted first, because rounding
/// hardly affects them.
Line settle(std::span<const double> inverses, double guess) {
  std::vector<double> steps(inverses.size(), 0.0);
  for (std::size_t i = 1; i < inverses.size(); ++i)
    steps[i] = steps[i - 1] + std::max(1.0, std::round((inverses[i] - inverses[i - 1]) / guess));
  Line line = fit_line(inverses, steps);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < inverses.size(); ++i) steps[i] = std::round((inverses[i] - line.farthest) / line.step);
    const Line better = fit_line(inverses, steps);
    if (!(better.step > 0.0)) break;
    line = better;
  }
  return line;
}

/// Cost of a law: the number of levels that it does not express, plus a small amount for each step without a level.
double misses(const DisparityLaw& law, std::span<const std::uint16_t> levels) {
  double sum = 0.1 * law.step_of(levels.front());
  for (const std::uint16_t level : levels) sum += law.level_at(law.step_of(level)) == level ? 0.0 : 1.0;
  return sum;
}

}  // namespace

std::uint32_t DisparityLaw::step_of(std::uint16_t level) const noexcept {
  const std::uint64_t inverse = (kOne + level / 2) / level;
  if (inverse <= farthest) return 0;
  const std::uint64_t n = (inverse - farthest + step / 2) / step;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(n, kMostSteps));
}

std::optional<DisparityLaw> fit_disparity_law(std::span<const std::uint16_t> levels) {
  if (levels.size() < kFewest || levels.size() > kMost) return std::nullopt;
  const auto one = static_cast<double>(DisparityLaw::kOne);
  std::vector<double> inverses;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) inverses.push_back(one / *level);
  std::vector<double> gaps;
  for (std::size_t i = 1; i < inverses.size(); ++i) gaps.push_back(inverses[i] - inverses[i - 1]);
  std::sort(gaps.begin(), gaps.end());
  std::optional<DisparityLaw> best;
  double fewest = static_cast<double>(levels.size());
  for (const std::size_t share :
       {std::size_t{2}, std::size_t{4}}) {  // the usual gap between levels is one step; with few levels, the gap of one
                                            // step is among the small ones
    const Line line = settle(inverses, gaps[gaps.size() * share / 8]);
    if (!(line.step >= 1.0) || !(line.farthest >= 1.0) || !(line.step < 4e9) || !(line.farthest <= one)) continue;
    const DisparityLaw law{static_cast<std::uint64_t>(std::llround(line.farthest)),
                           static_cast<std::uint32_t>(std::llround(line.step))};
    if (law.step_of(levels.front()) >= DisparityLaw::kMostSteps) continue;
    if (const double missed = misses(law, levels); missed < fewest) {
      best = law;
      fewest = missed;
    }
  }
  return best;
}

}  // namespace telepalp::codec
