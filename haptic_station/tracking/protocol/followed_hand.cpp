#include "haptic_station/tracking/protocol/followed_hand.h"

#include <algorithm>

namespace telepalp::tracking {
namespace {

constexpr double kSameWithin_m = 0.06;  // a hand farther than this from the predicted position is not the followed hand
constexpr double kOtherAfter_s = 0.3;   // another hand is followed when the followed one has been missing for this long

}  // namespace

double FollowedHand::apart_m(double time_s, const leap::Hand& hand) const noexcept {
  // The position is extrapolated with the last velocity for at most a tenth of a second; later that velocity is
  // meaningless.
  const double ahead_s = std::clamp(time_s - seen_s_, 0.0, 0.1);
  return (hand.palm.m - (last_->palm.m + last_->velocity.v * ahead_s)).norm();
}

std::optional<leap::Hand> FollowedHand::choose(double time_s, std::span<const leap::Hand> hands) noexcept {
  const bool clock_went_back = last_ && time_s < seen_s_;  // the service was restarted
  const leap::Hand* best = nullptr;
  if (!last_ || clock_went_back || time_s - seen_s_ > kOtherAfter_s) {
    if (!hands.empty()) best = &hands.front();  // the service lists the hand that it has tracked longest first
    for (const leap::Hand& hand : hands)
      if (last_ && hand.id == last_->id) best = &hand;
  } else {
    for (const leap::Hand& hand : hands) {
      if (apart_m(time_s, hand) > kSameWithin_m) continue;
      const bool nearer = best == nullptr || apart_m(time_s, hand) < apart_m(time_s, *best);
      const bool best_is_it = best != nullptr && best->id == last_->id;
      if ((nearer && !best_is_it) || hand.id == last_->id) best = &hand;
    }
  }
  if (best == nullptr) return std::nullopt;
  last_ = *best;
  seen_s_ = time_s;
  return last_;
}

}  // namespace telepalp::tracking
