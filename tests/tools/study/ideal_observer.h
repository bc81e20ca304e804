#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "tools/study/jnd/quest.h"
#include "tools/study/jnd/staircase.h"

namespace telepalp::study {

/// Thresholds that runs found, divided by the observer's true one.
struct FoundThresholds {
  double mean = 0.0;
  double deviation = 0.0;
  double within_tenth = 0.0;  ///< share of runs within 10 %
  double trials = 0.0;        ///< mean number of trials of a run
};

[[nodiscard]] inline FoundThresholds summary_of(const std::vector<double>& found, double trials) {
  FoundThresholds out{.trials = trials};
  const double n = static_cast<double>(found.size());
  for (const double one : found) {
    out.mean += one / n;
    out.within_tenth += std::abs(one - 1.0) <= 0.1 ? 1.0 / n : 0.0;
  }
  for (const double one : found) out.deviation += (one - out.mean) * (one - out.mean) / n;
  out.deviation = std::sqrt(out.deviation);
  return out;
}

/// An observer who feels both stimuli with Gaussian noise, and answers which is stiffer. Its draws, not the fitted
/// function, decide.
class IdealObserver {
 public:
  IdealObserver(double weber_fraction, double at, std::uint64_t seed)
      : noise_(weber_fraction / (std::sqrt(2.0) * normal_quantile(at))), random_(seed) {}
  [[nodiscard]] bool is_right(double difference) {
    std::normal_distribution<double> feel(0.0, noise_);
    const double stiffer = difference + feel(random_), reference = feel(random_);
    return stiffer > reference;
  }

 private:
  double noise_;
  std::mt19937_64 random_;
};

[[nodiscard]] inline FoundThresholds staircase_thresholds(double weber_fraction, const StaircaseSettings& settings,
                                                          double target, int seeds) {
  std::vector<double> found;
  double trials = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    IdealObserver observer(weber_fraction, target, static_cast<std::uint64_t>(seed));
    Staircase staircase(settings);
    while (!staircase.ended()) staircase.answer(observer.is_right(staircase.difference()));
    found.push_back(*staircase.threshold() / weber_fraction);
    trials += static_cast<double>(staircase.trials()) / seeds;
  }
  return summary_of(found, trials);
}

[[nodiscard]] inline FoundThresholds quest_thresholds(double weber_fraction, int trials, int seeds) {
  std::vector<double> found;
  for (int seed = 1; seed <= seeds; ++seed) {
    IdealObserver observer(weber_fraction, 0.75, static_cast<std::uint64_t>(seed));
    Quest quest;
    for (int i = 0; i < trials; ++i) quest.answer(observer.is_right(quest.difference()));
    found.push_back(quest.difference() / weber_fraction);
  }
  return summary_of(found, trials);
}

}  // namespace telepalp::study
