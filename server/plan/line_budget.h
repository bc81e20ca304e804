#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::plan {

/// What the server knows of one subscriber's line. It counts the camera's images (depth and colour) since the
/// subscriber joined.
struct LineReport {
  std::uint64_t offered = 0;              ///< images for the subscriber
  std::uint64_t dropped = 0;              ///< images that the line had no room for
  std::uint64_t sent_B = 0;               ///< bytes of the images that were sent, without repairs
  std::optional<double> share_B_per_s{};  ///< rate that other flows leave; nullopt: no other flow was noticed
  Nanoseconds queue{0};                   ///< standing queue of the line; 0 if it is not measured
};

/// How many bytes of images per second a line has room for. A line shows its rate only while it is full, so the budget
/// is cut to the rate at which images left while images were dropped or a queue stood. After 0.8 s without either, a
/// rate of 10 % more is tried for 0.8 s, and becomes the budget if it fits; while the line proves to be wider, the
/// steps are larger. After a try that does not fit, the next one waits twice as long, at most 2 s. The budget ends when
/// all images fit. Loss without a queue changes nothing, because repairs make up for it. Pure.
class LineBudget {
 public:
  /// `full_B_per_s`: rate of the images if nothing is given up. Call it about five times a second.
  void step(const LineReport& report, double full_B_per_s, SessionTime now) noexcept;

  /// The budget; nullopt: as far as known, the line has room for everything.
  [[nodiscard]] std::optional<double> B_per_s() const noexcept { return budget_; }
  /// The budget, raised by the present try: for content that may be lost. 0 without a budget.
  [[nodiscard]] double tried_B_per_s() const noexcept { return std::max(tried_B_per_s_, budget_.value_or(0.0)); }

 private:
  struct LastStep {
    std::uint64_t images = 0;   ///< offered in it
    double rate_B_per_s = 0.0;  ///< at which images were sent
  };
  [[nodiscard]] bool is_full(const LineReport& report, double full_B_per_s) const noexcept;
  void cut(const LineReport& report, const LastStep& last, SessionTime now) noexcept;
  void grow(const LineReport& report, double full_B_per_s, SessionTime now) noexcept;

  std::optional<LineReport> last_;
  SessionTime stepped_at_{};
  double smooth_B_per_s_ = 0.0;           ///< mean rate at which images were sent
  double offered_ = 0.0, dropped_ = 0.0;  ///< images since the last cut; older ones fade
  std::optional<double> budget_;
  double tried_B_per_s_ = 0.0;     ///< 0: nothing is tried
  double begun_at_B_per_s_ = 0.0;  ///< the budget before the present tries
  SessionTime cut_at_{};
  SessionTime calm_since_{};  ///< since then, the line was not full
  SessionTime tried_at_{};
  Nanoseconds patience_{0};  ///< from a calm line to the next try; set by each cut
};

}  // namespace telepalp::plan
