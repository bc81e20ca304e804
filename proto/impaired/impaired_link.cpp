#include "proto/impaired/impaired_link.h"

#include <algorithm>
#include <utility>

namespace telepalp::impaired {
namespace {

/// Bound on the memory of one direction: a long fat pipe holds less (1 Gbit/s for half a second).
constexpr std::size_t kMostHeld_B = std::size_t{64} << 20U;

Impairment bounded(Impairment impairment) noexcept {
  impairment.jitter = std::min(impairment.jitter, impairment.delay);
  return impairment;
}

}  // namespace

ImpairedLink::ImpairedLink(const Impairment& impairment, std::uint64_t seed, Trace trace)
    : impairment_(bounded(impairment)),
      trace_(std::move(trace)),
      random_(seed),
      loss_(impairment.loss, impairment.burst_packets) {}

void ImpairedLink::change(Nanoseconds now, const Impairment& impairment) noexcept {
  const auto waiting_B = static_cast<double>(queued_B(now));
  impairment_ = bounded(impairment);
  loss_.set(impairment_.loss, impairment_.burst_packets);
  const double rate_B_per_s = impairment_.rate_B_per_s;
  bottleneck_free_at_ = rate_B_per_s > 0.0 ? now + from_seconds(waiting_B / rate_B_per_s) : now;
}

double ImpairedLink::uniform() noexcept { return static_cast<double>(random_() >> 11U) * 0x1.0p-53; }

void ImpairedLink::follow_trace(Nanoseconds now) noexcept {
  if (trace_.size() < 2) return;
  const Nanoseconds within = now % trace_.back().at;
  const auto next = std::upper_bound(trace_.begin(), trace_.end(), within,
                                     [](Nanoseconds at, const TraceRow& row) { return at < row.at; });
  const TraceRow& row = *std::prev(next);
  impairment_.delay = row.delay;
  impairment_.jitter = std::min(row.jitter, row.delay);
  impairment_.rate_B_per_s = row.rate_B_per_s;
  loss_.set(row.loss, impairment_.burst_packets);
}

/// The end of the outage at `now`; nullopt: the link is up.
std::optional<Nanoseconds> ImpairedLink::outage_end(Nanoseconds now) const noexcept {
  if (trace_.size() >= 2 && impairment_.rate_B_per_s <= 0.0) {
    const Nanoseconds within = now % trace_.back().at;
    for (const TraceRow& row : trace_)
      if (row.at > within && row.rate_B_per_s > 0.0) return now - within + row.at;
    return now - within + trace_.back().at;
  }
  if (impairment_.outage_every <= Nanoseconds{0}) return std::nullopt;
  const Nanoseconds within = now % impairment_.outage_every;
  if (within < impairment_.outage_every - impairment_.outage_for) return std::nullopt;
  return now - within + impairment_.outage_every;
}

std::size_t ImpairedLink::queued_B(Nanoseconds now) const noexcept {
  const double wait_s = to_seconds(std::max(Nanoseconds{0}, bottleneck_free_at_ - now));
  return static_cast<std::size_t>(wait_s * impairment_.rate_B_per_s);
}

bool ImpairedLink::has_room(Nanoseconds now, std::size_t bytes) const noexcept {
  return held_B_ + bytes <= kMostHeld_B &&
         (impairment_.rate_B_per_s <= 0.0 || queued_B(now) + bytes <= impairment_.queue_B);
}

/// Puts `bytes` in the bottleneck's queue and returns when the last of them has left it.
Nanoseconds ImpairedLink::leave_queue(Nanoseconds now, std::size_t bytes) noexcept {
  if (impairment_.rate_B_per_s <= 0.0) return now;
  bottleneck_free_at_ =
      std::max(now, bottleneck_free_at_) + from_seconds(static_cast<double>(bytes) / impairment_.rate_B_per_s);
  return bottleneck_free_at_;
}

Nanoseconds ImpairedLink::propagation() noexcept {
  if (impairment_.jitter <= Nanoseconds{0}) return impairment_.delay;
  return impairment_.delay + from_seconds((2.0 * uniform() - 1.0) * to_seconds(impairment_.jitter));
}

void ImpairedLink::send(Nanoseconds now, Packet packet) {
  follow_trace(now);
  ++statistics_.sent;
  statistics_.sent_bytes += packet.bytes.size();
  if (packet.stream)
    send_segment(now, std::move(packet));
  else
    send_datagram(now, std::move(packet));
}

void ImpairedLink::send_datagram(Nanoseconds now, Packet packet) {
  const bool lost = loss_.lost(uniform());
  if (!has_room(now, packet.bytes.size())) {
    ++statistics_.dropped;
    return;
  }
  const Nanoseconds left = leave_queue(now, packet.bytes.size());
  if (lost || outage_end(left)) {
    ++statistics_.lost;
    return;
  }
  Nanoseconds arrives = left + propagation();
  if (happens(impairment_.reorder)) {
    ++statistics_.reordered;
    arrives += impairment_.reorder_by;
  }
  if (happens(impairment_.duplicate)) {
    ++statistics_.duplicated;
    hold(now, left + propagation(), packet);
  }
  if (happens(impairment_.corrupt)) corrupt(packet);
  hold(now, arrives, std::move(packet));
}

void ImpairedLink::send_segment(Nanoseconds now, Packet packet) {
  Nanoseconds left = leave_queue(now, packet.bytes.size());
  if (const auto end = outage_end(left)) {
    ++statistics_.lost;
    left = *end;
  }
  Nanoseconds arrives = left + propagation();
  if (loss_.lost(uniform())) {
    ++statistics_.lost;
    arrives += 2 * impairment_.delay;
  }
  Nanoseconds& last = last_segment_[packet.flow];
  last = std::max(last, arrives);
  hold(now, last, std::move(packet));
}

void ImpairedLink::corrupt(Packet& packet) noexcept {
  if (packet.bytes.empty()) return;
  ++statistics_.corrupted;
  const std::uint64_t bit = random_() % (packet.bytes.size() * 8);
  packet.bytes[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
}

void ImpairedLink::hold(Nanoseconds now, Nanoseconds arrives, Packet packet) {
  held_B_ += packet.bytes.size();
  held_.push({arrives, arrivals_++, now, std::move(packet)});
}

std::optional<Packet> ImpairedLink::receive(Nanoseconds now) {
  if (held_.empty() || held_.top().at > now) return std::nullopt;
  const Arrival& first = held_.top();
  ++statistics_.delivered;
  statistics_.delivered_bytes += first.packet.bytes.size();
  statistics_.worst_delay = std::max(statistics_.worst_delay, first.at - first.sent_at);
  held_B_ -= first.packet.bytes.size();
  Packet packet = std::move(const_cast<Arrival&>(first).packet);  // pop() would destroy it
  held_.pop();
  return packet;
}

std::optional<Nanoseconds> ImpairedLink::next_arrival() const {
  return held_.empty() ? std::nullopt : std::optional(held_.top().at);
}

}  // namespace telepalp::impaired
