#include "proto/link/datagram_link.h"

#include <algorithm>
#include <utility>

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

/// Least time between two reports: about ten reports in a round trip across a continent.
constexpr Nanoseconds kReportEvery = 5ms;

Direction sends(End end) noexcept { return end == End::Client ? Direction::ClientToServer : Direction::ServerToClient; }
Direction hears(End end) noexcept { return end == End::Client ? Direction::ServerToClient : Direction::ClientToServer; }

std::uint32_t microseconds(Nanoseconds span) noexcept {
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(span / 1us, 0, UINT32_MAX));
}

}  // namespace

DatagramLink::DatagramLink(const DatagramLinkSettings& settings, End end)
    : sealer_(settings.seal, sends(end)),
      opener_(settings.seal, hears(end)),
      sender_(settings.deadline),
      receiver_(settings.deadline, settings.most_assembling_B),
      takes_frames_(settings.takes_frames) {}

bool DatagramLink::seal(std::span<const std::byte> head, std::span<const std::byte> tail, SessionTime now,
                        Datagram& into) {
  const std::optional<std::uint64_t> sequence = sealer_.seal(head, tail, into);
  if (sequence) path_.sent(*sequence, into.size, now);
  return sequence.has_value();
}

std::optional<std::vector<std::byte>> DatagramLink::feedback_due(SessionTime now) {
  receiver_.step(now);
  const bool waits = receiver_.assembling_B() > 0;  // a request may be due, or the last one was lost
  if ((!unreported_ && !waits) || now - reported_at_ < kReportEvery) return std::nullopt;
  unreported_ = false;
  reported_at_ = now;
  return write_feedback({.highest_sequence = highest_sequence_,
                         .received_bytes = received_bytes_,
                         .reported_ns = to_nanoseconds(now),
                         .held_us = microseconds(now - highest_at_),
                         .settled = losses_.settled(),
                         .lost = losses_.lost(),
                         .bursts = losses_.bursts(),
                         .age_us = microseconds(newest_age_),
                         .key_frames_wanted = receiver_.key_frames_wanted(),
                         .missing = receiver_.missing(now)});
}

std::optional<SessionTime> DatagramLink::due(SessionTime now) const noexcept {
  if (challenged_) return now;
  if (sender_.holds_fragments()) return now + path_.next_look();
  std::optional<SessionTime> next = sender_.echo_due();
  if (unreported_ || receiver_.assembling_B() > 0)
    next = std::min(next.value_or(SessionTime::max()), reported_at_ + kReportEvery);
  return next ? std::optional(std::max(now, *next)) : std::nullopt;
}

bool DatagramLink::next(SessionTime now, Datagram& into) {
  if (const auto nonce = std::exchange(challenged_, std::nullopt))
    return seal(write_path_probe(PayloadKind::PathResponse, *nonce), {}, now, into);
  if (const auto feedback = feedback_due(now)) return seal(*feedback, {}, now, into);
  if (const auto fragment = sender_.next(now, path_)) return seal(fragment->header, fragment->shard, now, into);
  return false;
}

std::optional<Datagram> DatagramLink::next(SessionTime now) {
  std::optional<Datagram> datagram(std::in_place);
  if (!next(now, *datagram)) datagram.reset();
  return datagram;
}

bool DatagramLink::challenge(std::uint64_t nonce, SessionTime now, Datagram& into) {
  return seal(write_path_probe(PayloadKind::PathChallenge, nonce), {}, now, into);
}

void DatagramLink::count(const Opened& opened, std::size_t bytes, SessionTime now) {
  losses_.received(opened.sequence, now);
  received_bytes_ += bytes;
  if (!opened.newest) return;
  highest_sequence_ = opened.sequence;
  highest_at_ = now;
}

std::optional<bool> DatagramLink::received(std::span<const std::byte> datagram, SessionTime now) {
  const std::optional<Opened> opened = opener_.open(datagram);
  if (!opened) return std::nullopt;
  count(*opened, datagram.size(), now);
  if (const auto fragment = read_fragment(opened->payload)) {
    if (takes_frames_) receiver_.add(*fragment, now);
    unreported_ = true;
  } else if (const auto feedback = read_feedback(opened->payload)) {
    path_.on_feedback(*feedback, now);
    sender_.on_missing(feedback->missing, now, path_);
    peer_wants_ |= feedback->key_frames_wanted;
  } else if (const auto nonce = read_path_probe(PayloadKind::PathChallenge, opened->payload)) {
    challenged_ = nonce;
  } else if (const auto repeated = read_path_probe(PayloadKind::PathResponse, opened->payload)) {
    response_ = repeated;
  }
  return opened->newest;
}

std::optional<Frame> DatagramLink::take(SessionTime now) {
  std::optional<Frame> frame = receiver_.take();
  if (frame) newest_age_ = now - frame->captured;
  return frame;
}

}  // namespace telepalp::link
