#include "server/plan/line_budget.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace telepalp::plan {
namespace {

using namespace std::chrono_literals;

// A line is full:
constexpr double kMostDropped = 0.1;      ///< share of dropped images; a single late burst drops fewer
constexpr double kFewest_images = 4.0;    ///< the share says little of fewer images
constexpr Nanoseconds kLongQueue = 40ms;  ///< above the 33 ms between two images: each one waits for the one before
constexpr double kMargin = 1.15;          ///< of the share that other flows leave, over the budget: for repairs
// The budget after a cut:
constexpr double kCut = 0.92;   ///< of the rate at which images left, so that the queue empties
constexpr double kFits = 0.98;  ///< of the budget that fitted, after a try for more that did not fit
constexpr double kSameLine =
    0.75;                      ///< after a failed try, the line has kept its width if this share of the budget is sent
constexpr double kFell = 0.6;  ///< less than this share of the mean rate leaves in one step: the line fell
constexpr std::uint64_t kEnough_images = 6;  ///< a rate of fewer images says little
constexpr double kLeast_B_per_s = 4000.0;    ///< a try multiplies the budget, so it must not become 0
// Tries for more:
constexpr double kStep = 1.1;
constexpr double kLargeStep = 1.3;      ///< while the line proves to be wider
constexpr double kOutgrown = 1.2;       ///< the line proves to be wider when tries have multiplied the budget by this
constexpr Nanoseconds kTryFor = 800ms;  ///< long enough for a queue to build up if the step does not fit
constexpr double kRoom = 1.1;           ///< the budget ends at this many times the full rate
constexpr Nanoseconds kPatience = 800ms;
constexpr Nanoseconds kMostPatience = 2s;

constexpr Nanoseconds kSettles = 500ms;  ///< after a cut, images of the old size still wait
constexpr Nanoseconds kSmooth = 400ms;   ///< time constant of means: two steps

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
  const LastStep last{.images = report.offered - before.offered,
                      .rate_B_per_s = static_cast<double>(report.sent_B - before.sent_B) / span_s};
  const double keep = smooth_B_per_s_ > 0.0 ? std::exp(-span_s / to_seconds(kSmooth)) : 0.0;
  smooth_B_per_s_ = keep * smooth_B_per_s_ + (1.0 - keep) * last.rate_B_per_s;
  offered_ = keep * offered_ + static_cast<double>(last.images);
  dropped_ = keep * dropped_ + static_cast<double>(report.dropped - before.dropped);
  if (budget_ && now - cut_at_ < kSettles) {
    offered_ = dropped_ = 0.0;
    calm_since_ = now;
    return;
  }
  if (is_full(report, full_B_per_s)) return cut(report, last, now);
  if (budget_ && now - calm_since_ >= patience_) grow(report, full_B_per_s, now);
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

void LineBudget::cut(const LineReport& report, const LastStep& last, SessionTime now) noexcept {
  // A single step with enough images shows that a line has become much thinner. The mean would follow too late.
  const bool fell = last.images >= kEnough_images && last.rate_B_per_s < kFell * smooth_B_per_s_;
  const double left_B_per_s = fell ? last.rate_B_per_s : smooth_B_per_s_;
  const bool tried = budget_ && tried_B_per_s_ > 0.0 && left_B_per_s > kSameLine * *budget_;
  patience_ = tried ? std::min(2 * patience_, kMostPatience) : kPatience;
  double room = tried ? std::min(kFits * *budget_, left_B_per_s) : kCut * left_B_per_s;
  tried_B_per_s_ = 0.0;
  if (report.share_B_per_s) room = std::min(room, *report.share_B_per_s / kMargin);
  budget_ = std::max(kLeast_B_per_s, std::min(budget_.value_or(room), room));
  offered_ = dropped_ = 0.0;
  cut_at_ = calm_since_ = now;
}

}  // namespace telepalp::plan
