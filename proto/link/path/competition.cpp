#include "proto/link/path/competition.h"

#include <algorithm>
#include <cmath>

#include "proto/link/format/fragment.h"

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kQueueBegins = 15ms;  ///< as the target of the sender that is alone
constexpr Nanoseconds kQueueStands = 20ms;
constexpr Nanoseconds kNearlyEmpty = 5ms;
constexpr Nanoseconds kEmptyFor = 1s;
constexpr Nanoseconds kYieldsAtLeast = 200ms;  ///< PathMoment::queue looks back as far
constexpr int kYieldRoundTrips = 3;            ///< halving the rate each round trip leaves an eighth of an own queue
constexpr double kYieldsTo = 0.4;
constexpr double kFallsTo = 0.5;
/// A full buffer drops more than this share of the packets. A path that loses packets by chance loses less.
constexpr double kOverflows = 0.03;
/// Time between two yields beside other flows. A yield delays the images, so each yield in vain doubles this time.
constexpr Nanoseconds kProbeFirstAfter = 3s;
constexpr Nanoseconds kProbeAtLeastEvery = 12s;
constexpr double kHeldBack = 0.7;  ///< share of the last second in which the window held datagrams back

/// The window is as large as that of this many connections together, as in Chromium's QUIC: with one connection's
/// share, the images of a touch would be the first to be late.
constexpr double kConnections = 2.0;
constexpr double kCubicScale = 0.4;                                        ///< RFC 9438: C
constexpr double kCubicKeeps = (kConnections - 1.0 + 0.7) / kConnections;  ///< RFC 9438: beta, for one of them
constexpr double kRenoGain = 3.0 * kConnections * kConnections * (1.0 - kCubicKeeps) / (1.0 + kCubicKeeps);
/// A window of which less than this share is in flight does not grow: nothing shows that the path would carry more.
constexpr double kUsedShare = 1.0 / 3.0;
/// The least images, 25 a second, take about this rate; but at most a share of what was sent before others came.
constexpr double kLeastRate_B_per_s = 0.8e6;
constexpr double kLeastShare = 0.3;
constexpr double kArrivesAtLeast = 0.8;
constexpr Nanoseconds kUsualFor = 60s;
constexpr Nanoseconds kThinnerAfter = 5s;
constexpr double kMostWindow_B = 8.0 * (1U << 20U);

}  // namespace

std::optional<double> Competition::share_B_per_s() const noexcept {
  if (!beside() || round_trip_ <= 0ns) return std::nullopt;
  return window_B_ / to_seconds(round_trip_);
}

void Competition::yield(const PathMoment& moment, Phase as) {
  phase_ = as;
  onset_ = {moment.now, moment.queue, moment.round_trip, moment.rate_B_per_s, moment.sent};
  settled_ = lost_ = 0.0;
}

/// True if the path has dropped more than kOverflows of the packets since the yield began: a short buffer is full.
bool Competition::overflowed() const noexcept { return lost_ > kOverflows * settled_; }

bool Competition::yielded_enough(const PathMoment& moment) const noexcept {
  return moment.now - onset_.at >= kYieldsAtLeast + kYieldRoundTrips * onset_.round_trip;
}

bool Competition::fell(const PathMoment& moment) const noexcept {
  if (phase_ == Phase::Yielding && overflowed()) return false;
  if (phase_ == Phase::Probing) return moment.queue <= kQueueBegins / 2;
  const Nanoseconds half{static_cast<std::int64_t>(kFallsTo * static_cast<double>(onset_.queue.count()))};
  return moment.queue <= std::max<Nanoseconds>(kQueueStands, half);
}

std::uint64_t Competition::half_B(const PathMoment& moment) const noexcept {
  return static_cast<std::uint64_t>(kYieldsTo * onset_.rate_B_per_s * to_seconds(moment.round_trip));
}

std::uint64_t Competition::step(const PathMoment& moment, std::uint64_t delay_limit_B) {
  round_trip_ = moment.round_trip;
  const double span_s = std::min(1.0, to_seconds(moment.now - stepped_at_));
  held_back_ += ((moment.saturated ? 1.0 : 0.0) - held_back_) * span_s / to_seconds(kEmptyFor);
  stepped_at_ = moment.now;
  note_usual_rate(moment, span_s);
  // Losses are known many datagrams later. Those of datagrams sent before the yield began say nothing of the yield.
  if (static_cast<std::int32_t>(settled_until_ - onset_.sent) >= 0) {
    settled_ += moment.settled;
    lost_ += moment.lost;
  }
  settled_until_ = moment.settled_until;
  switch (phase_) {
    case Phase::Alone:
      if (moment.queue > kQueueBegins) yield(moment, Phase::Yielding);
      break;
    case Phase::Yielding:
      onset_.queue = std::max(onset_.queue, moment.queue);  // it rises until the yield takes effect
      if (moment.queue < kQueueBegins / 2 && !overflowed())
        phase_ = Phase::Alone;
      else if (yielded_enough(moment) && fell(moment))
        yield(moment, Phase::Yielding);
      else if (yielded_enough(moment))
        begin_beside(moment);
      break;
    case Phase::Beside:
      hold_share(moment);
      if (queue_is_gone(moment))
        phase_ = Phase::Alone;
      else if (held_back_ > kHeldBack && moment.now - probed_at_ > probe_after_)
        yield(moment, Phase::Probing);
      break;
    case Phase::Probing:
      if (!yielded_enough(moment)) break;
      probed_at_ = moment.now;
      probe_after_ = std::min(2 * probe_after_, kProbeAtLeastEvery);
      phase_ = fell(moment) ? Phase::Alone : Phase::Beside;
      break;
  }
  if (phase_ == Phase::Yielding) return std::max(delay_limit_B, half_B(moment));
  if (phase_ == Phase::Probing) return half_B(moment);
  return phase_ == Phase::Beside ? static_cast<std::uint64_t>(window_B_) : delay_limit_B;
}

/// Begins with the window of the rate before the other flows came. It grows at once: nothing was lost at it yet.
void Competition::begin_beside(const PathMoment& moment) {
  phase_ = Phase::Beside;
  window_B_ = usual_B(moment);
  keeps_rate_ = true;
  before_loss_B_ = window_B_;
  lost_at_ = moment.now - from_seconds(turn_s());
  probed_at_ = moment.now;
  probe_after_ = kProbeFirstAfter;
  empty_since_.reset();
}

/// Follows the best rate of the last minute. Beside others it stays, unless not even the least rate arrives: the line
/// became thinner.
void Competition::note_usual_rate(const PathMoment& moment, double span_s) noexcept {
  const bool thinner = beside() && moment.rate_B_per_s < kArrivesAtLeast * least_rate_B_per_s();
  if (!beside() || thinner) usual_rate_B_per_s_ *= std::exp(-span_s / to_seconds(thinner ? kThinnerAfter : kUsualFor));
  if (!beside()) usual_rate_B_per_s_ = std::max(usual_rate_B_per_s_, moment.rate_B_per_s);
}

double Competition::least_rate_B_per_s() const noexcept {
  return std::min(kLeastRate_B_per_s, kLeastShare * usual_rate_B_per_s_);
}

double Competition::usual_B(const PathMoment& moment) const noexcept {
  return usual_rate_B_per_s_ * to_seconds(moment.round_trip);
}

double Competition::least_B(const PathMoment& moment) const noexcept {
  return least_rate_B_per_s() * to_seconds(moment.round_trip);
}

/// Time from a loss until CUBIC's window is as large as before the loss (RFC 9438: K).
double Competition::turn_s() const noexcept {
  return std::cbrt(before_loss_B_ / static_cast<double>(kDatagramBytes) * (1.0 - kCubicKeeps) / kCubicScale);
}

/// CUBIC's window at `moment`, or Reno's where that is larger.
double Competition::target_B(const PathMoment& moment) const noexcept {
  const double packet_B = static_cast<double>(kDatagramBytes);
  const double most = before_loss_B_ / packet_B;
  const double since_s = to_seconds(moment.now - lost_at_);
  const double round_trip_s = std::max(1e-3, to_seconds(moment.round_trip));
  const double cubic = kCubicScale * std::pow(since_s + round_trip_s - turn_s(), 3.0) + most;
  const double reno = most * kCubicKeeps + kRenoGain * since_s / round_trip_s;
  return std::max(cubic, reno) * packet_B;
}

/// Losses of one round trip are one event. Before the first loss, the window grows with the queue, so that
/// the rate stays as it was.
void Competition::hold_share(const PathMoment& moment) {
  if (moment.lost > 0 && moment.now - lost_at_ > moment.round_trip) {
    before_loss_B_ = window_B_;
    window_B_ *= kCubicKeeps;
    lost_at_ = moment.now;
    keeps_rate_ = false;
  } else if (keeps_rate_ && window_B_ < usual_B(moment)) {
    window_B_ = before_loss_B_ = usual_B(moment);
  } else if (static_cast<double>(moment.in_flight_B) > kUsedShare * window_B_) {
    const double acknowledged = static_cast<double>(moment.acknowledged_B);
    window_B_ += std::clamp((target_B(moment) - window_B_) / window_B_, 0.0, 0.5) * acknowledged;
  }
  window_B_ =
      std::clamp(window_B_, std::max(least_B(moment), 16.0 * static_cast<double>(kDatagramBytes)), kMostWindow_B);
}

bool Competition::queue_is_gone(const PathMoment& moment) noexcept {
  if (moment.queue > kNearlyEmpty)
    empty_since_.reset();
  else if (!empty_since_)
    empty_since_ = moment.now;
  return empty_since_ && moment.now - *empty_since_ > kEmptyFor;
}

}  // namespace telepalp::link
