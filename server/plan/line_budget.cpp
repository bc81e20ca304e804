#include "server/plan/line_budget.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace telepalp::plan {
namespace {

using namespace std::chrono_literals;

constexpr double kMostDropped = 0.1;
constexpr double kFewest_images = 4.0;  ///< one dropped image of fewer says little
constexpr Nanoseconds kLongQueue = 40ms;
constexpr double kMargin = 1.15;  ///< of a share, for repairs
constexpr double kCut = 0.92;     ///< of what left for the line: so that its queue empties
constexpr double kStep = 1.1;
constexpr Nanoseconds kTryFor = 800ms;  ///< a queue of images builds up meanwhile, if the step does not fit
constexpr double kOutgrown = 1.2;       ///< times what fitted before: the line has become wider
constexpr double kLargeStep = 1.3;
constexpr double kFits = 0.98;  ///< of what fitted before a try that did not
constexpr double kSameLine =
    0.75;  ///< of what fitted before still left for the line, so that it has not become thinner
constexpr double kFell = 0.6;
constexpr std::uint64_t kEnough_images = 6;
constexpr double kRoom = 1.1;            ///< times the full rate: the budget ends
constexpr Nanoseconds kSettles = 500ms;  ///< images of the old size still wait after a cut
constexpr Nanoseconds kPatience = 800ms;
constexpr Nanoseconds kMostPatience = 2s;
constexpr Nanoseconds kSmooth = 400ms;
constexpr double kLeast_B_per_s = 4000.0;

}  // namespace

void LineBudget::step(const LineReport& report, double full_B_per_s, SessionTime now) noexcept {
  const bool continues = last_ && report.offered >= last_->offered && report.sent_B >= last_->sent_B &&
                         report.dropped >= last_->dropped && now > stepped_at_;
  const LineReport before = continues ? *last_ : report;
  const double span_s = to_seconds(now - std::exchange(stepped_at_, now));
  last_ = report;
  if (!continues) {
    calm_since_ = now;
    return;
  }
  images_ = report.offered - before.offered;
  rate_B_per_s_ = static_cast<double>(report.sent_B - before.sent_B) / span_s;
  const double keep = smooth_B_per_s_ > 0.0 ? std::exp(-span_s / to_seconds(kSmooth)) : 0.0;
  smooth_B_per_s_ = keep * smooth_B_per_s_ + (1.0 - keep) * rate_B_per_s_;
  offered_ = keep * offered_ + static_cast<double>(report.offered - before.offered);
  dropped_ = keep * dropped_ + static_cast<double>(report.dropped - before.dropped);
  if (budget_ && now - cut_at_ < kSettles) {
    offered_ = dropped_ = 0.0;
    calm_since_ = now;
    return;
  }
  if (is_full(report, full_B_per_s)) return cut(report, now);
  if (budget_ && now - calm_since_ >= std::max(patience_, kPatience)) grow(report, full_B_per_s, now);
}

void LineBudget::grow(const LineReport& report, double full_B_per_s, SessionTime now) noexcept {
  const bool is_first = tried_B_per_s_ <= 0.0;
  if (is_first) begun_at_B_per_s_ = *budget_;
  const bool is_wider = *budget_ > kOutgrown * begun_at_B_per_s_;
  if (!is_first && !is_wider && now - tried_at_ < kTryFor) return;
  if (!is_first) budget_ = tried_B_per_s_;
  tried_at_ = now;
  tried_B_per_s_ = (is_wider ? kLargeStep : kStep) * *budget_;
  if (report.share_B_per_s) tried_B_per_s_ = std::min(tried_B_per_s_, *report.share_B_per_s / kMargin);
  if (*budget_ <= kRoom * full_B_per_s) return;
  budget_.reset();
  tried_B_per_s_ = 0.0;
}

bool LineBudget::is_full(const LineReport& report, double full_B_per_s) const noexcept {
  const bool drops = offered_ >= kFewest_images && dropped_ > kMostDropped * offered_;
  if (!report.share_B_per_s) return drops || report.queue > kLongQueue;
  return drops || *report.share_B_per_s < kMargin * budget_.value_or(std::min(full_B_per_s, smooth_B_per_s_));
}

void LineBudget::cut(const LineReport& report, SessionTime now) noexcept {
  // One step with enough images tells at once that a line has become much thinner.
  const bool fell = images_ >= kEnough_images && rate_B_per_s_ < kFell * smooth_B_per_s_;
  const double left_B_per_s = fell ? rate_B_per_s_ : smooth_B_per_s_;
  const bool tried = budget_ && tried_B_per_s_ > 0.0 && left_B_per_s > kSameLine * *budget_;
  patience_ = tried ? std::clamp(2 * patience_, 2 * kPatience, kMostPatience) : kPatience;
  double room = tried ? std::min(kFits * *budget_, left_B_per_s) : kCut * left_B_per_s;
  tried_B_per_s_ = 0.0;
  if (report.share_B_per_s) room = std::min(room, *report.share_B_per_s / kMargin);
  budget_ = std::max(kLeast_B_per_s, std::min(budget_.value_or(room), room));
  offered_ = dropped_ = 0.0;
  cut_at_ = calm_since_ = now;
}

}  // namespace telepalp::plan
