#include "tools/replay/cell/camera_path.h"

#include <array>
#include <cstring>
#include <utility>

namespace telepalp::replay {
namespace {

/// A secret that differs for each link session, so that datagrams of an earlier session are refused. It need not be
/// secret, because both ends are in this process.
link::DatagramLinkSettings settings_of(const Scenario& scenario, std::uint32_t link_session) {
  std::array<std::byte, link::Secret::kBytes> secret{};
  std::memcpy(secret.data(), &scenario.seed, sizeof scenario.seed);
  std::memcpy(secret.data() + sizeof scenario.seed, &link_session, sizeof link_session);
  return {.seal = {.session = link::Secret(secret), .number = link_session, .cipher = link::Cipher::Aes256Gcm},
          .deadline = scenario.deadline};
}

Nanoseconds since_begin(SessionTime now) noexcept { return now - kBegin; }

}  // namespace

CameraPath::CameraPath(const Scenario& scenario, Wires wires) : scenario_(scenario), wires_(std::move(wires)) {
  begin_link_session();
}

void CameraPath::begin_link_session() {
  const link::DatagramLinkSettings settings = settings_of(scenario_, link_sessions_++);
  ends_ =
      std::make_unique<Ends>(Ends{.server = {settings, link::End::Server}, .station = {settings, link::End::Client}});
}

bool CameraPath::server_is_away(SessionTime now) const noexcept {
  return any_contains(scenario_.faults.restarts, since_begin(now));
}

bool CameraPath::offer(link::Frame frame) { return ends_->server.offer(std::move(frame)).has_value(); }

void CameraPath::exchange(SessionTime now) {
  const bool away = server_is_away(now);
  if (std::exchange(was_away_, away) && !away) begin_link_session();
  deliver(*wires_.up, ends_->server, now);
  deliver(*wires_.down, ends_->station, now);
  if (!away) counts_.sent_B += transmit(ends_->server, *wires_.down, now);
  counts_.answered_B += transmit(ends_->station, *wires_.up, now);
  counts_.lost = wires_.down->lost();
}

/// Delivers the packets that have arrived over `from` to `to`. After a restart, datagrams of the session before still
/// arrive; `to` refuses them, because they were sealed with another key.
void CameraPath::deliver(Wire& from, link::DatagramLink& to, SessionTime now) {
  while (const auto packet = from.receive(since_begin(now))) (void)to.received(*packet, now);
}

std::uint64_t CameraPath::transmit(link::DatagramLink& from, Wire& to, SessionTime now) {
  const bool cut = any_contains(scenario_.faults.outages, since_begin(now));
  std::uint64_t bytes = 0;
  while (const std::optional<link::Datagram> datagram = from.next(now)) {
    const auto span = datagram->bytes();
    bytes += span.size();
    if (!cut) to.send(since_begin(now), span);
  }
  return bytes;
}

std::optional<link::Frame> CameraPath::take(SessionTime now) { return ends_->station.take(now); }

void CameraPath::request_key_frame(SessionTime now) {
  if (!key_frame_request_) key_frame_request_ = now + scenario_.up.delay;
}

bool CameraPath::key_frame_wanted(SessionTime now) {
  const bool requested = key_frame_request_ && *key_frame_request_ <= now;
  if (requested) key_frame_request_.reset();
  return (ends_->server.key_frames_wanted() & (1U << kDepthChannel)) != 0 || requested;
}

}  // namespace telepalp::replay
