#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "proto/link/format/fragment.h"
#include "proto/link/path/windowed_extreme.h"
#include "proto/words/time.h"

namespace telepalp::link {

/// Rate, delay and loss of a path, as its sender knows them from the receiver's feedback, and the bound on data in
/// flight that follows. Pure: time is an argument.
class PathEstimate {
 public:
  /// A datagram of `bytes` left at `now`.
  void sent(std::uint64_t sequence, std::size_t bytes, SessionTime now);
  /// Ignores feedback that is older than the last one, or acknowledges nothing, or a datagram that was not sent.
  void on_feedback(const Feedback& feedback, SessionTime now);

  /// True if a datagram may be sent now. Without feedback for a while all data in flight counts as lost.
  [[nodiscard]] bool has_room(SessionTime now) noexcept;

  [[nodiscard]] Nanoseconds round_trip() const noexcept { return round_trip_; }  ///< smoothed; 0: unknown
  [[nodiscard]] Nanoseconds least_round_trip() const noexcept { return least_round_trip_; }
  /// Delay by queues in the sender's direction; jitter is not in it.
  [[nodiscard]] Nanoseconds queue_delay() const noexcept { return queue_delay_; }
  [[nodiscard]] double loss() const noexcept { return loss_; }                    ///< share of packets
  [[nodiscard]] double burst_packets() const noexcept { return burst_packets_; }  ///< mean, at least 1
  [[nodiscard]] double rate_B_per_s() const noexcept { return rate_B_per_s_; }    ///< rate of delivery; 0: unknown
  [[nodiscard]] std::uint64_t in_flight_B() const noexcept { return sent_bytes_ - acknowledged_; }
  [[nodiscard]] std::uint64_t limit_B() const noexcept { return limit_B_; }
  [[nodiscard]] Nanoseconds reported_age() const noexcept { return reported_age_; }  ///< of the newest complete frame
  /// Reports that acknowledged a datagram which no earlier report did: the path works in both directions.
  [[nodiscard]] std::uint64_t answers() const noexcept { return answers_; }

 private:
  struct Sent {
    std::uint64_t sequence;
    SessionTime at;
    std::uint64_t total_B;  ///< sent up to and including this datagram
  };
  /// The least delay of the newest moment and of a long time. Their difference is the queue: in each moment some
  /// packets meet little jitter, but none passes the queue.
  struct LeastDelay {
    WindowedMinimum<Nanoseconds> of_a_moment;
    WindowedMinimum<Nanoseconds> of_a_long_time;
  };
  struct Report {
    std::int64_t at_ns;
    std::uint64_t received_B;
  };
  void measure_delay(Nanoseconds round_trip, Nanoseconds one_way, SessionTime now);
  void measure_rate(const Feedback& feedback, SessionTime now);
  void measure_loss(const Feedback& feedback);
  void adapt_limit(std::uint64_t acknowledged_now);
  [[nodiscard]] bool drains(SessionTime now) noexcept;

  std::deque<Sent> on_the_way_;
  std::uint64_t sent_bytes_ = 0;
  std::uint64_t acknowledged_ = 0;
  std::optional<Feedback> last_;
  std::uint64_t answers_ = 0;
  SessionTime last_heard_{};
  LeastDelay round_trips_;
  LeastDelay one_way_;          ///< with the unknown difference of the two clocks
  std::deque<Report> reports_;  ///< reports of the last fifth of a second
  Nanoseconds round_trip_{0};
  Nanoseconds least_round_trip_{0};
  Nanoseconds queue_delay_{0};
  SessionTime least_seen_at_{};
  bool draining_ = false;
  Nanoseconds reported_age_{0};
  double settled_ = 0.0;  ///< decayed counts
  double lost_ = 0.0;
  double bursts_ = 0.0;
  double loss_ = 0.01;
  double burst_packets_ = 1.0;
  double rate_B_per_s_ = 0.0;
  WindowedMaximum<double> rates_;
  double best_rate_B_per_s_ = 0.0;  ///< of the last round trips: a pause of the sender does not lower it
  std::uint64_t limit_B_ = std::uint64_t{1} << 20U;
};

/// Number of repair shards to send at once with a block of `data_shards`. `repairable`: a request for more shards and
/// its answer fit before the frame's deadline.
[[nodiscard]] std::size_t repair_shards(std::size_t data_shards, double loss, double burst_packets,
                                        bool repairable) noexcept;

}  // namespace telepalp::link
