#include "tools/study/jnd/staircase.h"

#include <cmath>
#include <numbers>

namespace telepalp::study {

double normal_share(double z) noexcept { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

Staircase::Staircase(const StaircaseSettings& settings)
    : settings_(settings), log_difference_(std::log(settings.first)) {
  reversals_.reserve(static_cast<std::size_t>(settings.reversals) + 1);
}

double Staircase::difference() const noexcept { return std::exp(log_difference_); }

bool Staircase::ended() const noexcept { return static_cast<int>(reversals_.size()) >= settings_.reversals; }

void Staircase::answer(bool right) noexcept {
  if (ended()) return;
  ++trials_;
  if (!right) {
    right_ = 0;
    turn(1);
  } else if (++right_ >= settings_.right_in_a_row) {
    right_ = 0;
    turn(-1);
  }
}

void Staircase::turn(int direction) noexcept {
  if (direction_ != 0 && direction != direction_) reversals_.push_back(log_difference_);
  direction_ = direction;
  log_difference_ += direction > 0 ? settings_.step_up : -settings_.step_up * settings_.down_by_up;
  log_difference_ = std::fmin(log_difference_, std::log(settings_.most));
}

std::optional<double> Staircase::threshold() const noexcept {
  if (!ended()) return std::nullopt;
  double sum = 0.0;
  const auto first = static_cast<std::size_t>(settings_.first_reversals);
  for (std::size_t i = first; i < reversals_.size(); ++i) sum += reversals_[i];
  return std::exp(sum / static_cast<double>(reversals_.size() - first));
}

double normal_quantile(double share) noexcept {
  double z = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    z -= std::fmax(-1.0, std::fmin(1.0, (normal_share(z) - share) / std::fmax(density, 1e-12)));
  }
  return z;
}

}  // namespace telepalp::study
