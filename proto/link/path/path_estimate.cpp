#include "proto/link/path/path_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kDelayMemory = 10s;  ///< a route may change
/// The same beside flows that fill the queue: the queue may not be empty for minutes.
constexpr Nanoseconds kDelayMemoryBeside = 300s;
constexpr Nanoseconds kMoment = 200ms;  ///< about forty reports: one of them met hardly any jitter
constexpr Nanoseconds kRateSpan = 200ms;
constexpr Nanoseconds kBestRateSpan = 1s;
constexpr Nanoseconds kQueueTarget = 15ms;
constexpr Nanoseconds kLongQueue = 60ms;
constexpr Nanoseconds kSilence = 1s;
/// A burst of datagrams would overflow a queue that other flows fill, or a short one. So the sender spreads an image's
/// datagrams: it sends at this multiple of its share, or of its best rate when it is alone, so that the image has left
/// before the next one comes. When the timer was late, the sender makes up for at most kPaceBurst.
constexpr double kPaceGain = 1.5;
constexpr Nanoseconds kPaceBurst = 2ms;
/// Above this loss and this number of losses in a row, a queue overflows: it drops the end of each image. Losses by
/// chance are rarer, or fewer in a row.
constexpr double kOverflowLoss = 0.02;
constexpr double kOverflowBurst_packets = 6.0;
constexpr Nanoseconds kLookPaced = 1ms;
constexpr Nanoseconds kLookForRoom = 5ms;  ///< without feedback, only time makes room
constexpr Nanoseconds kDrainAfter = 5s;    ///< half of the memory
constexpr Nanoseconds kNoQueue = 3ms;
/// Bound on a difference of the two ends' clocks, so that what a peer claims cannot overflow a difference.
constexpr Nanoseconds kMostClockDifference = 24h;
constexpr std::uint64_t kLeastLimit_B = 16 * kDatagramBytes;
/// kLeastLimit_B on a thin path, where 16 datagrams would be a long queue.
constexpr std::uint64_t kLeastThinLimit_B = 4 * kDatagramBytes;
/// What urgent datagrams may add to the limit: speech with its echoes for about 0.1 s.
constexpr std::uint64_t kUrgentReserve_B = 10 * kDatagramBytes;
constexpr std::uint64_t kMostLimit_B = std::uint64_t{8} << 20U;
constexpr double kLossMemory_packets = 30'000.0;  ///< about ten seconds of a camera
/// kLossMemory_packets beside other flows. Shorter, because a full queue then causes the losses: it overflows less as
/// soon as the sender sends less, and repair shards for losses that are over would fill it again.
constexpr double kLossMemoryBeside_packets = 5'000.0;
constexpr double kPriorPackets = 200.0;  ///< weight of the first guess
constexpr double kPriorLoss = 0.01;

constexpr Nanoseconds kReceiverWaits = 15ms;  ///< from a loss to its request: reordering 5 ms, report 5 ms, margin
constexpr double kHardlyAnyLoss = 0.001;      ///< a packet of an image of 91 kB is lost every 13th image

/// As many packets in flight as a window of sequence numbers: a sender that is never acknowledged stays bounded.
constexpr std::size_t kMostOnTheWay = 65'536;

}  // namespace

void PathEstimate::sent(std::uint64_t sequence, std::size_t bytes, SessionTime now) {
  if (sent_bytes_ == 0) last_heard_ = now;
  sent_bytes_ += bytes;
  if (const std::optional<double> pace = pace_B_per_s(); pace && *pace > 0.0)
    paced_until_ = std::max(paced_until_, now - kPaceBurst) + from_seconds(static_cast<double>(bytes) / *pace);
  on_the_way_.push_back({sequence, now, sent_bytes_});
  if (on_the_way_.size() > kMostOnTheWay) on_the_way_.pop_front();
}

void PathEstimate::on_feedback(const Feedback& feedback, SessionTime now) {
  const bool older =
      last_ && (feedback.highest_sequence < last_->highest_sequence || feedback.reported_ns <= last_->reported_ns);
  if (older || feedback.received_bytes == 0 || on_the_way_.empty() ||
      feedback.highest_sequence > on_the_way_.back().sequence)
    return;
  if (!last_ || feedback.highest_sequence > last_->highest_sequence) ++answers_;
  const std::uint64_t before = acknowledged_;
  while (!on_the_way_.empty() && on_the_way_.front().sequence < feedback.highest_sequence) on_the_way_.pop_front();
  if (!on_the_way_.empty() && on_the_way_.front().sequence == feedback.highest_sequence) {
    acknowledged_ = std::max(acknowledged_, on_the_way_.front().total_B);
    const SessionTime left = on_the_way_.front().at;
    const Nanoseconds held = std::chrono::microseconds(feedback.held_us);
    const SessionTime arrived{Nanoseconds(feedback.reported_ns) - held};
    if (now - left > held) measure_delay(now - left - held, arrived - left, now);
  }
  last_heard_ = now;
  reported_age_ = std::chrono::microseconds(feedback.age_us);
  measure_rate(feedback, now);
  const Losses losses = measure_loss(feedback);
  adapt_limit(acknowledged_ - before, losses, feedback.settled, now);
  last_ = feedback;
}

/// The round trip also has the jitter of the reports, and the one-way delay the corrections of the peer's clock. A
/// queue in the sender's direction shows in both.
void PathEstimate::measure_delay(Nanoseconds round_trip, Nanoseconds one_way, SessionTime now) {
  const Nanoseconds memory = beside_others() ? kDelayMemoryBeside : kDelayMemory;
  const auto add = [now, memory](LeastDelay& to, Nanoseconds delay) {
    const Nanoseconds least = to.of_a_long_time.add(delay, now, memory);
    return std::pair(least, to.of_a_moment.add(delay, now, kMoment) - least);
  };
  round_trip_ = round_trip_ == 0ns ? round_trip : round_trip_ + (round_trip - round_trip_) / 8;
  const auto [least_round_trip, queue_there_and_back] = add(round_trips_, round_trip);
  const auto [least_one_way, queue_there] =
      add(one_way_, std::clamp<Nanoseconds>(one_way, -kMostClockDifference, kMostClockDifference));
  least_round_trip_ = least_round_trip;
  queue_delay_ = std::min(queue_there_and_back, queue_there);
  if (queue_delay_ <= kNoQueue) least_seen_at_ = now;
}

void PathEstimate::measure_rate(const Feedback& feedback, SessionTime now) {
  reports_.push_back({feedback.reported_ns, feedback.received_bytes});
  while (Nanoseconds(feedback.reported_ns - reports_.front().at_ns) > kRateSpan) reports_.pop_front();
  const double span_s = to_seconds(Nanoseconds(feedback.reported_ns - reports_.front().at_ns));
  const std::uint64_t received = feedback.received_bytes - reports_.front().received_B;
  if (span_s >= 0.5 * to_seconds(kRateSpan) && feedback.received_bytes >= reports_.front().received_B)
    rate_B_per_s_ = static_cast<double>(received) / span_s;
  best_rate_B_per_s_ = rates_.add(rate_B_per_s_, now, std::max<Nanoseconds>(kBestRateSpan, 2 * round_trip_));
}

PathEstimate::Losses PathEstimate::measure_loss(const Feedback& feedback) {
  const Feedback before = last_.value_or(Feedback{});
  const Losses now{.settled = feedback.settled - before.settled, .lost = feedback.lost - before.lost};
  const double settled = now.settled, lost = now.lost;
  const double bursts = static_cast<std::uint32_t>(feedback.bursts - before.bursts);
  if (lost > settled || bursts > lost) return {};  // the receiver's counts contradict each other
  const double keep = std::exp(-settled / (beside_others() ? kLossMemoryBeside_packets : kLossMemory_packets));
  settled_ = settled_ * keep + settled;
  lost_ = lost_ * keep + lost;
  bursts_ = bursts_ * keep + bursts;
  loss_ = (lost_ + kPriorLoss * kPriorPackets) / (settled_ + kPriorPackets);
  burst_packets_ = (lost_ + 2.0) / (bursts_ + 2.0);
  return now;
}

/// True after a silence, while the limit is below half of what it was and no long queue builds up. Few packets are in
/// flight then, so jitter looks like a short queue.
bool PathEstimate::recovers() noexcept {
  if (limit_B_ >= recover_to_B_ || queue_delay_ > std::max<Nanoseconds>(kLongQueue, round_trip_ / 4)) recover_to_B_ = 0;
  return recover_to_B_ > 0;
}

/// The least value of the limit: kLeastLimit_B, or on a thin path what it delivers in its least round trip and
/// kQueueTarget.
std::uint64_t PathEstimate::least_limit_B() const noexcept {
  if (best_rate_B_per_s_ <= 0.0) return kLeastLimit_B;
  const double thin_B = best_rate_B_per_s_ * to_seconds(least_round_trip_ + kQueueTarget);
  return std::clamp(static_cast<std::uint64_t>(thin_B), kLeastThinLimit_B, kLeastLimit_B);
}

/// Grows the limit while the round trip is near its least. When a queue builds up, the limit becomes what the path
/// delivers in a round trip without the queue, jitter included, and the target.
void PathEstimate::keep_queue_short(std::uint64_t acknowledged_now) {
  // A path with a long queue is never idle, so its rate of delivery is all that it carries. If its rate has just
  // fallen, the best rate is still that from before, and the smoothed round trip lags behind the queue.
  const bool is_long = queue_delay_ > kLongQueue;
  const double path_B_per_s = is_long ? rate_B_per_s_ : best_rate_B_per_s_;
  const Nanoseconds without_queue = is_long ? least_round_trip_ : round_trip_ - queue_delay_;
  if (queue_delay_ > kQueueTarget && path_B_per_s > 0.0)
    delay_limit_B_ =
        std::min(delay_limit_B_, static_cast<std::uint64_t>(path_B_per_s * to_seconds(without_queue + kQueueTarget)));
  else if (queue_delay_ < kQueueTarget / 2)
    delay_limit_B_ += acknowledged_now / 4;
  delay_limit_B_ = std::clamp(delay_limit_B_, least_limit_B(), kMostLimit_B);
}

/// `settled_until`: Feedback::settled. on_feedback() has checked that on_the_way_ is not empty.
void PathEstimate::adapt_limit(std::uint64_t acknowledged_now, const Losses& losses, std::uint32_t settled_until,
                               SessionTime now) {
  if (recovers()) {
    limit_B_ = delay_limit_B_ = std::min(limit_B_ + acknowledged_now, recover_to_B_);
    return;
  }
  const bool was_beside = beside_others();
  if (!was_beside) keep_queue_short(acknowledged_now);
  limit_B_ = competition_.step({.now = now,
                                .queue = queue_delay_,
                                .round_trip = round_trip_,
                                .rate_B_per_s = rate_B_per_s_,
                                .acknowledged_B = acknowledged_now,
                                .in_flight_B = in_flight_B(),
                                .sent = static_cast<std::uint32_t>(on_the_way_.back().sequence + 1),
                                .settled_until = settled_until,
                                .settled = losses.settled,
                                .lost = losses.lost,
                                .saturated = std::exchange(saturated_, false)},
                               delay_limit_B_);
  if (was_beside)
    delay_limit_B_ = std::clamp(static_cast<std::uint64_t>(competition_.window_B()), least_limit_B(), kMostLimit_B);
  limit_B_ = std::clamp(limit_B_, least_limit_B(), kMostLimit_B);
}

/// True while sending pauses so that the queue runs empty. Without a pause, the least round trip of a path that is
/// always full would be forgotten, and the queue itself taken for the path.
bool PathEstimate::drains(SessionTime now) noexcept {
  if (beside_others()) {
    least_seen_at_ = now;
    draining_ = false;
  }
  if (round_trip_ > 0ns && now - least_seen_at_ > kDrainAfter) {
    draining_ = true;
    least_seen_at_ = now;
  }
  if (in_flight_B() < least_limit_B()) draining_ = false;
  return draining_;
}

std::optional<double> PathEstimate::delivered_share_B_per_s() const noexcept {
  const std::optional<double> share = share_B_per_s();
  return share ? std::optional(std::min(*share, best_rate_B_per_s_)) : std::nullopt;
}

std::optional<double> PathEstimate::pace_B_per_s() const noexcept {
  if (const std::optional<double> share = share_B_per_s()) return kPaceGain * *share;
  const bool overflows = loss_ > kOverflowLoss && burst_packets_ > kOverflowBurst_packets;
  return overflows ? std::optional(kPaceGain * best_rate_B_per_s_) : std::nullopt;
}

/// After a silence, all data in flight counts as lost.
void PathEstimate::note_silence(SessionTime now) noexcept {
  if (in_flight_B() == 0 || now - last_heard_ <= std::max<Nanoseconds>(kSilence, 4 * round_trip_)) return;
  acknowledged_ = sent_bytes_;
  recover_to_B_ = std::max(recover_to_B_, limit_B_ / 2);
  limit_B_ = delay_limit_B_ = kLeastLimit_B;
  competition_.forget();
  last_heard_ = now;
}

bool PathEstimate::has_room_for_urgent(SessionTime now) noexcept {
  note_silence(now);
  return in_flight_B() + kDatagramBytes <= limit_B_ + kUrgentReserve_B;
}

bool PathEstimate::has_room(SessionTime now) noexcept {
  note_silence(now);
  const bool full = in_flight_B() + kDatagramBytes > limit_B_;
  saturated_ = saturated_ || full;
  return !drains(now) && !full && (!pace_B_per_s() || now >= paced_until_);
}

Nanoseconds PathEstimate::next_look() const noexcept { return pace_B_per_s() ? kLookPaced : kLookForRoom; }

bool can_repair(Nanoseconds left, const PathEstimate& path) noexcept {
  return path.round_trip() > 0ns && left > path.round_trip() * 3 / 2 + kReceiverWaits;
}

bool references_arrive(const PathEstimate& path, Nanoseconds deadline) noexcept {
  return path.round_trip() > 0ns && (path.loss() < kHardlyAnyLoss || can_repair(deadline, path));
}

namespace {

/// Blocks of at most so many data shards get repair shards by exact probabilities. For larger ones these need more
/// repair shards than two deviations, because the bursts have a long tail.
constexpr std::size_t kSmallBlock = 12;
constexpr std::size_t kMostOfSmallBlock = 6;
/// The share of small blocks that may need a repair round, and that may fail where none fits. The second one is ten
/// times that of large blocks: on a thin line, half as many repair shards as data shards cost more images than they
/// save.
constexpr double kSmallMayAsk = 0.02;
constexpr double kSmallMayFail = 0.003;

/// Probability that more than `repairs` of `packets` are lost; `repairs` is at most kMostOfSmallBlock. Bursts begin at
/// random and have geometric lengths: the distribution of Polya and Aeppli.
double more_are_lost(std::size_t packets, std::size_t repairs, double loss, double burst_packets) noexcept {
  const double burst = std::max(1.0, burst_packets);
  const double bursts = static_cast<double>(packets) * loss / burst;
  std::array<double, kMostOfSmallBlock + 1> lost{std::exp(-bursts)};
  double at_most = lost[0];
  for (std::size_t n = 1; n <= repairs; ++n) {
    double weight = bursts / static_cast<double>(n) / burst;
    for (std::size_t i = 1; i <= n; ++i, weight *= 1.0 - 1.0 / burst)
      lost[n] += static_cast<double>(i) * weight * lost[n - i];
    at_most += lost[n];
  }
  return 1.0 - at_most;
}

/// The least number of repair shards, up to `most`, with which few enough small blocks fail.
std::size_t small_block_repairs(std::size_t data_shards, std::size_t most, double loss, double burst_packets,
                                bool repairable) noexcept {
  const double may_fail = repairable ? kSmallMayAsk : kSmallMayFail;
  std::size_t repairs = 1;
  while (repairs < most && more_are_lost(data_shards + repairs, repairs, loss, burst_packets) > may_fail) ++repairs;
  return repairs;
}

}  // namespace

std::size_t repair_shards(std::size_t data_shards, double loss, double burst_packets, bool repairable) noexcept {
  const double k = static_cast<double>(data_shards);
  if (k * loss < (repairable ? 0.1 : 0.01)) return 0;
  // Bursts of mean B inflate the variance of a sum of losses by 2B - 1. 2 % of the blocks may need a repair round;
  // where none fits, 0.03 % may fail.
  const double deviations = repairable ? 2.0 : 3.5;
  const double inflation = 2.0 * std::max(1.0, burst_packets) - 1.0;
  auto most = static_cast<std::size_t>(std::ceil(0.4 * k)) + 1;
  if (data_shards <= kSmallBlock) most = small_block_repairs(data_shards, most, loss, burst_packets, repairable);
  for (std::size_t repairs = 1; repairs < most; ++repairs) {
    const double packets = k + static_cast<double>(repairs);
    const double expected = packets * loss + deviations * std::sqrt(packets * loss * (1.0 - loss) * inflation);
    if (static_cast<double>(repairs) >= expected + 0.5) return repairs;
  }
  return std::min(most, kMostRepairShards);
}

}  // namespace telepalp::link
