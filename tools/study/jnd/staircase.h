#pragma once

#include <optional>
#include <vector>

namespace telepalp::study {

/// An adaptive staircase for a difference threshold: one wrong answer makes the difference larger, three right answers
/// in a row make it smaller. Steps are ratios of the difference. Equal steps do not converge on 79.4 % correct; with
/// a step down of 0.7393 of the step up, 1-up-3-down converges on 83.15 % (García-Pérez 1998, Vision Research 38).
struct StaircaseSettings {
  double first = 0.5;          ///< stimulus difference of the first trial, as a Weber fraction
  double step_up = 0.25;       ///< in natural logarithms of the difference
  double down_by_up = 0.7393;  ///< step down over step up
  int right_in_a_row = 3;      ///< so many right answers in a row make the difference smaller
  int reversals = 24;          ///< the run ends after so many reversals
  int first_reversals = 4;     ///< so many reversals at the start are not averaged
  double most = 100.0;         ///< the difference is at most this one
};

inline constexpr double kStaircaseTarget = 0.8315;  ///< share of right answers at the threshold that a run finds

/// State of one run. Pure: the next difference follows from the answers so far.
class Staircase {
 public:
  explicit Staircase(const StaircaseSettings& settings = {});

  [[nodiscard]] double difference() const noexcept;  ///< of the next trial's stimuli, as a Weber fraction
  void answer(bool right) noexcept;
  [[nodiscard]] bool ended() const noexcept;
  [[nodiscard]] int trials() const noexcept { return trials_; }
  /// The geometric mean of the difference at the reversals, without the first ones; nullopt until the run has ended.
  [[nodiscard]] std::optional<double> threshold() const noexcept;

 private:
  void turn(int direction) noexcept;

  StaircaseSettings settings_;
  double log_difference_;
  int right_ = 0;
  int direction_ = 0;
  int trials_ = 0;
  std::vector<double> reversals_;  ///< natural logarithms of the differences at the reversals
};

/// The standard normal distribution.
[[nodiscard]] double normal_share(double z) noexcept;

/// The inverse of the standard normal distribution, for shares in (0, 1). Error: below 1e-9.
[[nodiscard]] double normal_quantile(double share) noexcept;

}  // namespace telepalp::study
