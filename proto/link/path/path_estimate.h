#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "proto/link/format/fragment.h"
#include "proto/link/path/competition.h"
#include "proto/link/path/windowed_extreme.h"
#include "proto/words/time.h"

namespace telepalp::link {

/// Rate, delay and loss of a path, which the sender estimates from the receiver's feedback, and the congestion window
/// that follows from them: limit_B(), a bound on the data in flight. Alone on the path, it keeps the queue short;
/// beside flows that fill the queue, it holds a fair share (Competition). Pure: time is an argument.
class PathEstimate {
 public:
  /// A datagram of `bytes` left at `now`.
  void sent(std::uint64_t sequence, std::size_t bytes, SessionTime now);
  /// Ignores feedback that is older than the last one, that reports no received byte, or that names a datagram that was
  /// not sent.
  void on_feedback(const Feedback& feedback, SessionTime now);

  /// True if a datagram may be sent now: in_flight_B() leaves room below limit_B(), and sending does not pause to empty
  /// the path's queue. Without feedback for the longer of 1 s and 4 round trips, all data in flight counts as lost, and
  /// limit_B() falls to its least value. Then it doubles with each round trip, up to half of its value before the fall.
  [[nodiscard]] bool has_room(SessionTime now) noexcept;
  /// The same for a datagram of an urgent frame (SharedFrame::Label): it may exceed limit_B() by a reserve, and neither
  /// pauses nor spreads. The window of a sender that sends little is hardly larger than what is in flight, so reports
  /// that were lost would hold speech back.
  [[nodiscard]] bool has_room_for_urgent(SessionTime now) noexcept;
  /// When to ask has_room() again while it says no and no feedback comes.
  [[nodiscard]] Nanoseconds next_look() const noexcept;

  [[nodiscard]] Nanoseconds round_trip() const noexcept { return round_trip_; }              ///< smoothed; 0: unknown
  [[nodiscard]] Nanoseconds least_round_trip() const noexcept { return least_round_trip_; }  ///< of the last 10 s
  /// Queueing delay in the direction of sending, without jitter.
  [[nodiscard]] Nanoseconds queue_delay() const noexcept { return queue_delay_; }
  [[nodiscard]] double loss() const noexcept { return loss_; }                    ///< share of packets
  [[nodiscard]] double burst_packets() const noexcept { return burst_packets_; }  ///< mean length of a loss burst
  [[nodiscard]] double rate_B_per_s() const noexcept { return rate_B_per_s_; }    ///< rate of delivery; 0: unknown
  [[nodiscard]] std::uint64_t in_flight_B() const noexcept { return sent_bytes_ - acknowledged_; }
  [[nodiscard]] std::uint64_t limit_B() const noexcept { return limit_B_; }
  [[nodiscard]] Nanoseconds reported_age() const noexcept { return reported_age_; }  ///< newest Feedback::age_us
  /// True while other flows fill the path's queue.
  [[nodiscard]] bool beside_others() const noexcept { return competition_.beside(); }
  /// Rate of the share that is left beside other flows; nullopt: none was noticed.
  [[nodiscard]] std::optional<double> share_B_per_s() const noexcept { return competition_.share_B_per_s(); }
  /// The same, but at most what the path has delivered in the last second. This is what people are told: a sender that
  /// uses a part of its share does not know whether the path would carry the rest.
  [[nodiscard]] std::optional<double> delivered_share_B_per_s() const noexcept;
  /// Number of reports that acknowledged a new datagram. While it grows, the path works in both directions.
  [[nodiscard]] std::uint64_t answers() const noexcept { return answers_; }

 private:
  struct Sent {
    std::uint64_t sequence;
    SessionTime at;
    std::uint64_t total_B;  ///< sent up to and including this datagram
  };
  /// The least delays of the last 0.2 s and of the last 10 s. Their difference is the queueing delay: in each 0.2 s
  /// some packets meet hardly any jitter, but all packets meet the queue.
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
  /// Packets that a report adds to the counts.
  struct Losses {
    std::uint32_t settled = 0;
    std::uint32_t lost = 0;
  };
  [[nodiscard]] Losses measure_loss(const Feedback& feedback);
  void adapt_limit(std::uint64_t acknowledged_now, const Losses& losses, std::uint32_t settled_until, SessionTime now);
  void keep_queue_short(std::uint64_t acknowledged_now);
  [[nodiscard]] std::uint64_t least_limit_B() const noexcept;
  [[nodiscard]] bool recovers() noexcept;
  /// The rate at which datagrams leave while an image is sent; nullopt: as fast as the socket takes them.
  [[nodiscard]] std::optional<double> pace_B_per_s() const noexcept;
  [[nodiscard]] bool drains(SessionTime now) noexcept;
  void note_silence(SessionTime now) noexcept;

  std::deque<Sent> on_the_way_;
  std::uint64_t sent_bytes_ = 0;
  std::uint64_t acknowledged_ = 0;
  std::optional<Feedback> last_;
  std::uint64_t answers_ = 0;
  SessionTime last_heard_{};
  LeastDelay round_trips_;
  LeastDelay one_way_;          ///< includes the unknown difference of the two clocks
  std::deque<Report> reports_;  ///< reports of the last fifth of a second
  Nanoseconds round_trip_{0};
  Nanoseconds least_round_trip_{0};
  Nanoseconds queue_delay_{0};
  SessionTime least_seen_at_{};
  bool draining_ = false;
  Nanoseconds reported_age_{0};
  double settled_ = 0.0;  ///< packet counts with exponential decay
  double lost_ = 0.0;
  double bursts_ = 0.0;
  double loss_ = 0.01;
  double burst_packets_ = 1.0;
  double rate_B_per_s_ = 0.0;
  WindowedMaximum<double> rates_;
  double best_rate_B_per_s_ = 0.0;  ///< best of 1 s, or of 2 round trips if longer: pauses in sending do not lower it
  std::uint64_t delay_limit_B_ = std::uint64_t{1} << 20U;  ///< keeps the queue short
  Competition competition_;
  bool saturated_ = false;  ///< limit_B_ held a datagram back since the last report
  SessionTime paced_until_{};
  std::uint64_t limit_B_ = delay_limit_B_;
  std::uint64_t recover_to_B_ = 0;  ///< after a silence: half of the limit before it; 0: no recovery
};

/// True if a lost packet of a frame that must arrive within `left` can be requested and repaired in time.
[[nodiscard]] bool can_repair(Nanoseconds left, const PathEstimate& path) noexcept;

/// True if frames may depend on each other: less than 0.1 % of the packets are lost, or a loss can be repaired within
/// `deadline`. A frame that cannot be repaired makes all frames that depend on it unreadable, until a key frame comes.
/// False for a path that is not measured yet.
[[nodiscard]] bool references_arrive(const PathEstimate& path, Nanoseconds deadline) noexcept;

/// Number of repair shards to send together with a block of `data_shards`. `loss`: share of packets that are lost.
/// `repairable`: a request for more shards and the answer can arrive before the frame's deadline.
[[nodiscard]] std::size_t repair_shards(std::size_t data_shards, double loss, double burst_packets,
                                        bool repairable) noexcept;

}  // namespace telepalp::link
