#include "tools/study/jnd/quest.h"

#include <cmath>

#include "tools/study/jnd/staircase.h"

namespace telepalp::study {
namespace {

constexpr int kSteps = 241;
constexpr double kReach = 3.0;  // half of the grid's width around the guess, in natural logarithms

}  // namespace

Quest::Quest(double guess, double deviation, double target, double lapses)
    : target_z_(normal_quantile(target)), lapses_(lapses) {
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double off = kReach * (2.0 * i / (kSteps - 1) - 1.0);
    log_threshold_.push_back(std::log(guess) + off);
    probability_.push_back(std::exp(-0.5 * off * off / (deviation * deviation)));
    sum += probability_.back();
  }
  for (double& p : probability_) p /= sum;
}

double Quest::difference() const noexcept {
  double mean = 0.0;
  for (std::size_t i = 0; i < probability_.size(); ++i) mean += probability_[i] * log_threshold_[i];
  return std::exp(mean);
}

void Quest::answer(bool right) noexcept {
  const double shown = difference();
  double sum = 0.0;
  for (std::size_t i = 0; i < probability_.size(); ++i) {
    const double share =
        0.5 * lapses_ + (1.0 - lapses_) * normal_share(target_z_ * shown / std::exp(log_threshold_[i]));
    probability_[i] *= right ? share : 1.0 - share;
    sum += probability_[i];
  }
  for (double& p : probability_) p /= sum;
}

}  // namespace telepalp::study
