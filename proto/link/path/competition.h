#pragma once

#include <cstdint>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::link {

/// What a sender knows of its path when a report of the receiver arrives.
struct PathMoment {
  SessionTime now{};
  Nanoseconds queue{0};       ///< least queueing delay of the last 0.2 s
  Nanoseconds round_trip{0};  ///< smoothed; queues included
  double rate_B_per_s = 0.0;  ///< rate of delivery in the last 0.2 s
  std::uint64_t acknowledged_B = 0;
  std::uint64_t in_flight_B = 0;
  std::uint32_t sent = 0;           ///< datagrams sent so far; wraps around
  std::uint32_t settled_until = 0;  ///< number of the first datagram that is not settled; wraps around
  std::uint32_t settled = 0;        ///< datagrams that this report is the first to state as arrived or lost
  std::uint32_t lost = 0;           ///< the lost ones among the datagrams `settled`
  bool saturated = false;           ///< datagrams waited since the previous report, because the window was full
};

/// Decides whether other flows fill the path's queue, and then holds a fair share of the path.
///
/// When a queue builds up, the sender yields: it halves its rate. Alone, its queue then falls in a few round trips,
/// at least to half of the longest one since the yield began. A queue that does not fall is another flow's, which fills
/// every buffer it finds; a sender that keeps to a short queue would starve beside it. So the congestion window then
/// follows losses, as the flow's beside it does (CUBIC, RFC 9438, with the window of two connections). While the window
/// holds datagrams back, the sender yields again after 3, 6, and then every 12 s. It returns to a short queue when the
/// queue falls, or is nearly empty for 1 s. The detection is Copa's (NSDI 2018, section 2.2) with an explicit yield,
/// because a camera does not fill the path.
///
/// Pure: time is part of each moment.
class Competition {
 public:
  enum class Phase : std::uint8_t { Alone, Yielding, Beside, Probing };

  /// `delay_limit_B`: the window by which the sender, alone, keeps the queue short. Returns the congestion window [B].
  [[nodiscard]] std::uint64_t step(const PathMoment& moment, std::uint64_t delay_limit_B);
  /// Call after a time without any report: other flows may have come or gone meanwhile.
  void forget() noexcept { phase_ = Phase::Alone; }

  /// True while other flows fill the path's queue.
  [[nodiscard]] bool beside() const noexcept { return phase_ == Phase::Beside || phase_ == Phase::Probing; }
  [[nodiscard]] Phase phase() const noexcept { return phase_; }
  /// The congestion window beside other flows, which a yield does not change [B].
  [[nodiscard]] double window_B() const noexcept { return window_B_; }
  /// Rate of the share that this sender holds; nullopt: it is alone.
  [[nodiscard]] std::optional<double> share_B_per_s() const noexcept;

 private:
  /// The path when a yield began.
  struct Onset {
    SessionTime at{};
    Nanoseconds queue{0};
    Nanoseconds round_trip{0};
    double rate_B_per_s = 0.0;
    std::uint32_t sent = 0;
  };
  void yield(const PathMoment& moment, Phase as);
  [[nodiscard]] bool yielded_enough(const PathMoment& moment) const noexcept;
  [[nodiscard]] bool overflowed() const noexcept;
  [[nodiscard]] bool fell(const PathMoment& moment) const noexcept;
  [[nodiscard]] std::uint64_t half_B(const PathMoment& moment) const noexcept;
  void begin_beside(const PathMoment& moment);
  void hold_share(const PathMoment& moment);
  [[nodiscard]] bool queue_is_gone(const PathMoment& moment) noexcept;
  [[nodiscard]] double turn_s() const noexcept;
  [[nodiscard]] double target_B(const PathMoment& moment) const noexcept;
  void note_usual_rate(const PathMoment& moment, double span_s) noexcept;
  [[nodiscard]] double least_rate_B_per_s() const noexcept;
  [[nodiscard]] double usual_B(const PathMoment& moment) const noexcept;
  [[nodiscard]] double least_B(const PathMoment& moment) const noexcept;

  Phase phase_ = Phase::Alone;
  Onset onset_;
  double settled_ = 0.0;             ///< packets that arrived or were lost since the yield began
  double lost_ = 0.0;                ///< packets that were lost since the yield began
  double usual_rate_B_per_s_ = 0.0;  ///< rate of delivery before other flows came
  double window_B_ = 0.0;
  double before_loss_B_ = 0.0;
  bool keeps_rate_ = false;  ///< true beside other flows until the first loss
  SessionTime lost_at_{};
  SessionTime probed_at_{};
  Nanoseconds probe_after_{0};
  std::optional<SessionTime> empty_since_;
  Nanoseconds round_trip_{0};
  SessionTime stepped_at_{};
  std::uint32_t settled_until_ = 0;  ///< PathMoment::settled_until of the last step
  double held_back_ = 0.0;
};

}  // namespace telepalp::link
