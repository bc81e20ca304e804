#include "proto/impaired/impaired_pair.h"

namespace telepalp::impaired {

ImpairedPair::ImpairedPair(SessionTime begin, const Profile& network, std::uint64_t seed,
                           const link::DatagramLinkSettings& settings)
    : begin_(begin), down_(network.down, seed), up_(network.up, seed + 1) {
  begin_link_session(settings);
}

void ImpairedPair::change(SessionTime now, const Profile& network) noexcept {
  down_.change(since_begin(now), network.down);
  up_.change(since_begin(now), network.up);
}

void ImpairedPair::begin_link_session(const link::DatagramLinkSettings& settings) {
  server_.emplace(settings, link::End::Server);
  client_.emplace(settings, link::End::Client);
}

void ImpairedPair::deliver(SessionTime now, const OnSegment& on_segment) {
  while (const auto packet = up_.receive(since_begin(now))) (void)server_->received(packet->bytes, now);
  while (const auto packet = down_.receive(since_begin(now))) {
    if (packet->stream)
      on_segment(packet->bytes.size());
    else
      (void)client_->received(packet->bytes, now);
  }
}

std::size_t ImpairedPair::transmit(link::DatagramLink& from, ImpairedLink& to, SessionTime now) {
  std::size_t sent_B = 0;
  while (const std::optional<link::Datagram> datagram = from.next(now)) {
    const auto bytes = datagram->bytes();
    to.send(since_begin(now), {.bytes = {bytes.begin(), bytes.end()}});
    sent_B += bytes.size();
  }
  return sent_B;
}

std::optional<SessionTime> ImpairedPair::due(SessionTime now) const {
  std::optional<SessionTime> earliest;
  const auto consider = [&](std::optional<SessionTime> at) {
    if (at && (!earliest || *at < *earliest)) earliest = at;
  };
  for (const ImpairedLink* link : {&down_, &up_})
    if (const std::optional<Nanoseconds> next = link->next_arrival()) consider(begin_ + *next);
  consider(server_->due(now));
  consider(client_->due(now));
  return earliest;
}

}  // namespace telepalp::impaired
