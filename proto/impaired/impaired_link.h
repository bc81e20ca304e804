#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <random>
#include <vector>

#include "proto/impaired/gilbert_elliott.h"
#include "proto/impaired/impairment.h"

namespace telepalp::impaired {

struct Packet {
  std::vector<std::byte> bytes;
  std::uint64_t flow = 0;  ///< number of its stream or pair of sockets, chosen by the caller of send()
  /// True: a segment of a TCP stream. A segment is neither lost nor damaged, nor overtaken in its stream. A loss delays
  /// the segment, and all segments behind it in the stream, by twice the link's delay: time to be sent again.
  bool stream = false;
};

/// Counters since the link's start. Each datagram is lost, dropped, delivered or still in the link. A TCP segment is
/// always delivered, and also counts as lost once for each loss that delays it.
struct LinkStatistics {
  std::uint64_t sent = 0;
  std::uint64_t sent_bytes = 0;
  std::uint64_t delivered = 0;  ///< duplicates included
  std::uint64_t delivered_bytes = 0;
  std::uint64_t lost = 0;     ///< datagrams lost, and TCP segments delayed, by the loss model or an outage
  std::uint64_t dropped = 0;  ///< datagrams that did not fit in the bottleneck's queue
  std::uint64_t reordered = 0;
  std::uint64_t duplicated = 0;
  std::uint64_t corrupted = 0;
  Nanoseconds worst_delay{0};  ///< longest time in the link
};

/// One direction of an impaired link. Pure: time is an argument. All times count from the link's start, and `now` never
/// decreases. Equal seeds and equal packets give equal arrivals on every machine.
class ImpairedLink {
 public:
  ImpairedLink(const Impairment& impairment, std::uint64_t seed, Trace trace = {});

  /// Changes the impairments at `now`. Packets in the link keep their times of arrival. Later packets wait until the
  /// bytes in the bottleneck's queue have left at the new rate. The values of a trace still replace those given here.
  void change(Nanoseconds now, const Impairment& impairment) noexcept;

  void send(Nanoseconds now, Packet packet);
  /// The next packet that has arrived by `now`; nullopt: none.
  [[nodiscard]] std::optional<Packet> receive(Nanoseconds now);
  /// When the next packet arrives; nullopt: the link is empty.
  [[nodiscard]] std::optional<Nanoseconds> next_arrival() const;

  /// Bytes in the bottleneck's queue.
  [[nodiscard]] std::size_t queued_B(Nanoseconds now) const noexcept;
  /// True if the bottleneck's queue has room for `bytes` more and the link would then hold at most 64 MiB. The sender
  /// of a TCP stream waits while has_room() is false.
  [[nodiscard]] bool has_room(Nanoseconds now, std::size_t bytes) const noexcept;
  /// Forgets a stream that has ended; its segments on the way still arrive.
  void forget_stream(std::uint64_t flow) { last_segment_.erase(flow); }
  [[nodiscard]] const LinkStatistics& statistics() const noexcept { return statistics_; }

 private:
  struct Arrival {
    Nanoseconds at;
    std::uint64_t number;  ///< order of sending: packets that arrive at one instant keep this order
    Nanoseconds sent_at;
    Packet packet;
    bool operator<(const Arrival& other) const noexcept {
      return at != other.at ? at > other.at : number > other.number;
    }
  };
  [[nodiscard]] double uniform() noexcept;
  [[nodiscard]] bool happens(double share) noexcept { return share > 0.0 && uniform() < share; }
  void follow_trace(Nanoseconds now) noexcept;
  [[nodiscard]] std::optional<Nanoseconds> outage_end(Nanoseconds now) const noexcept;
  [[nodiscard]] Nanoseconds leave_queue(Nanoseconds now, std::size_t bytes) noexcept;
  [[nodiscard]] Nanoseconds propagation() noexcept;
  void send_datagram(Nanoseconds now, Packet packet);
  void send_segment(Nanoseconds now, Packet packet);
  void corrupt(Packet& packet) noexcept;
  void hold(Nanoseconds now, Nanoseconds arrives, Packet packet);

  Impairment impairment_;
  Trace trace_;
  std::mt19937_64 random_;
  GilbertElliott loss_;
  Nanoseconds bottleneck_free_at_{0};
  std::priority_queue<Arrival> held_;
  std::size_t held_B_ = 0;
  std::uint64_t arrivals_ = 0;
  std::map<std::uint64_t, Nanoseconds> last_segment_;  ///< arrival of each stream's last segment
  LinkStatistics statistics_;
};

}  // namespace telepalp::impaired
