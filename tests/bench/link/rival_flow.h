#pragma once

#include <cstdint>
#include <deque>
#include <string_view>

#include "proto/impaired/impaired_link.h"

namespace telepalp::bench::link {

enum class RivalKind : std::uint8_t { Reno, Cubic, Bbr };
[[nodiscard]] std::string_view name(RivalKind kind) noexcept;

/// A download that shares the bottleneck: a bulk TCP sender as a model in virtual time. Reno (RFC 5681), Cubic
/// (RFC 9438, without HyStart), and BBR version 1 (rate and least round trip, eight gains, twice the bandwidth-delay
/// product in flight). Each packet is acknowledged, the acknowledgement of a later packet marks a loss, and a silence
/// of 1 s begins anew.
class RivalFlow {
 public:
  /// `flow`: number of its packets in the link. `back`: delay of the acknowledgements.
  RivalFlow(RivalKind kind, std::uint64_t flow, Nanoseconds back) noexcept : kind_(kind), flow_(flow), back_(back) {}

  /// Sends what it may at `now`.
  void step(Nanoseconds now, impaired::ImpairedLink& link);
  /// Packet of this flow arrived at its receiver.
  void arrived(const impaired::Packet& packet, Nanoseconds now);
  [[nodiscard]] std::uint64_t flow() const noexcept { return flow_; }
  [[nodiscard]] double received_B() const noexcept { return received_B_; }

 private:
  struct Sent {
    std::uint64_t sequence;
    Nanoseconds at;
    std::uint64_t delivered;  ///< packets delivered when it was sent
  };
  struct Ack {
    Nanoseconds at;
    std::uint64_t sequence;
  };
  void acknowledge(std::uint64_t sequence, Nanoseconds now);
  void grow(Nanoseconds now);
  void on_loss(Nanoseconds now);
  void measure(const Sent& sent, Nanoseconds now);
  [[nodiscard]] bool may_send(Nanoseconds now) const noexcept;
  [[nodiscard]] double window_packets() const noexcept;
  [[nodiscard]] double cubic_target(Nanoseconds now) const noexcept;

  RivalKind kind_;
  std::uint64_t flow_;
  Nanoseconds back_;
  std::deque<Sent> on_the_way_;
  std::deque<Ack> acks_;
  std::uint64_t next_ = 0;
  std::uint64_t delivered_ = 0;
  std::uint64_t recover_until_ = 0;  ///< losses of packets before this one belong to one event
  Nanoseconds heard_at_{0};
  Nanoseconds round_trip_{0};
  Nanoseconds least_{0};
  double window_ = 10.0;  ///< packets
  double threshold_ = 1e9;
  double most_ = 0.0;  ///< Cubic: window before the last reduction
  Nanoseconds epoch_{0};
  double best_rate_ = 0.0;  ///< BBR: packets a second
  std::deque<std::pair<Nanoseconds, double>> rates_;
  Nanoseconds paced_until_{0};
  double full_rate_ = 0.0;
  int rounds_without_growth_ = 0;
  Nanoseconds round_at_{0};
  bool started_ = false;  ///< BBR: left its start-up
  Nanoseconds least_at_{0};
  Nanoseconds probing_until_{0};
  double received_B_ = 0.0;
};

}  // namespace telepalp::bench::link
