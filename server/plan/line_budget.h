#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::plan {

/// What the server knows of one subscriber's line. Counts are of camera images (depth and colour), since it joined.
struct LineReport {
  std::uint64_t offered = 0;              ///< images for it
  std::uint64_t dropped = 0;              ///< images that the line had no room for
  std::uint64_t sent_B = 0;               ///< bytes of images that left for it, without repairs
  std::optional<double> share_B_per_s{};  ///< rate that other flows leave; nullopt: no other flow was noticed
  Nanoseconds queue{0};                   ///< standing queue of the line; 0 if it is not measured
};

/// How many bytes of images a second a line has room for. A line shows its rate only when it is full, so the budget
/// falls to what left for the line while images were dropped or a queue stood. After 0.8 s without either, more is
/// tried: 10 % for 0.8 s, which count as budget when they fitted, and larger steps when the line has become wider. If a
/// try does not fit, the next one waits twice as long, at most 2 s. The budget ends when all images fit. Loss without a
/// queue changes nothing, because repairs make up for it. Pure.
class LineBudget {
 public:
  /// `full_B_per_s`: rate of the images if nothing is given up. Call it about five times a second.
  void step(const LineReport& report, double full_B_per_s, SessionTime now) noexcept;

  /// nullopt: as far as known, the line has room for everything.
  [[nodiscard]] std::optional<double> B_per_s() const noexcept { return budget_; }
  /// The budget and what is tried above it, for content that may be lost. Only with a budget.
  [[nodiscard]] double tried_B_per_s() const noexcept { return std::max(tried_B_per_s_, budget_.value_or(0.0)); }

 private:
  [[nodiscard]] bool is_full(const LineReport& report, double full_B_per_s) const noexcept;
  void cut(const LineReport& report, SessionTime now) noexcept;
  void grow(const LineReport& report, double full_B_per_s, SessionTime now) noexcept;

  std::optional<LineReport> last_;
  SessionTime stepped_at_{};
  std::uint64_t images_ = 0;   ///< offered in the last step
  double rate_B_per_s_ = 0.0;  ///< of what left for the line in the last step
  double smooth_B_per_s_ = 0.0;
  double offered_ = 0.0, dropped_ = 0.0;  ///< images since the last cut, older ones fade
  std::optional<double> budget_;
  double tried_B_per_s_ = 0.0;     ///< 0: nothing is tried
  double begun_at_B_per_s_ = 0.0;  ///< the budget before the present tries
  SessionTime cut_at_{};
  SessionTime calm_since_{};
  SessionTime tried_at_{};
  Nanoseconds patience_{0};
};

}  // namespace telepalp::plan
