#include "server/hub/peer_datagrams.h"

#include <random>
#include <utility>

#include "proto/wire/datagram_message.h"
#include "proto/wire/sockets/udp_socket.h"

namespace telepalp::hub {

namespace {

std::function<void(link::Frame)> frames_to(const std::function<void(wire::Message)>& on_message) {
  if (!on_message) return {};
  return [on_message](const link::Frame& frame) {
    if (std::optional<wire::Message> message = wire::message_of(frame)) on_message(std::move(*message));
  };
}

}  // namespace

PeerDatagrams::PeerDatagrams(DatagramPort& port, Hub& hub, Peer peer)
    : port_(port), hub_(hub), peer_(std::move(peer)), number_(port.join(*this)) {}

PeerDatagrams::~PeerDatagrams() { close(); }

void PeerDatagrams::close() noexcept {
  if (closed_) return;
  closed_ = true;
  port_.leave(number_);
  if (end_) end_->close();
  if (paths_) paths_->close();
}

std::unique_ptr<PeerDatagrams> PeerDatagrams::offer(boost::asio::io_context& io, DatagramPort& port, Hub& hub,
                                                    msg::DatagramCipher wanted, const wire::KeyingMaterial& from_tls,
                                                    Peer peer) {
  std::unique_ptr<PeerDatagrams> made(new PeerDatagrams(port, hub, std::move(peer)));
  std::optional<wire::DatagramOffer> offer = wire::make_offer(made->number_, wanted, from_tls);
  if (!offer) return nullptr;
  made->offer_ = std::move(*offer);
  const SubscriberId subscriber = made->peer_.subscriber;
  made->end_ = std::make_unique<wire::DatagramEnd>(
      io.get_executor(), made->offer_.seal, link::End::Server,
      wire::DatagramEnd::Handlers{
          .send = [raw = made.get()](std::span<const std::byte> datagram) { return raw->send(datagram); },
          .next_frame = [&hub, subscriber,
                         raw = made.get()](wire::Wanted now) -> std::shared_ptr<const link::SharedFrame> {
            if (!raw->is_proved()) return nullptr;
            const std::optional<wire::Message> message = hub.next_for_datagram(subscriber, now);
            if (!message) return nullptr;
            return raw->port_.frames().frame_of(*message, raw->peer_.now());
          },
          .on_frame = frames_to(made->peer_.on_message),
          .on_key_frame_needed =
              [&hub, subscriber](std::uint8_t channel) {
                if (const auto topic = wire::topic_of_datagram_channel(channel)) hub.restart_group(subscriber, *topic);
              },
          .on_phase = [raw = made.get()](wire::DatagramPhase phase) { raw->on_phase(phase); },
          .now = made->peer_.now});
  if (made->peer_.signal) made->find_paths(io);
  return made;
}

void PeerDatagrams::find_paths(boost::asio::io_context& io) {
  offer_.message.set_finds_path(true);
  paths_ = std::make_unique<ice::IcePaths>(
      io.get_executor(),
      ice::IcePaths::Settings{.end = ice::IcePaths::End::Server,
                              .type_of_service = wire::type_of_service(wire::TrafficClass::Pictures)},
      ice::IcePaths::Handlers{.signal = peer_.signal,
                              .on_datagram =
                                  [this](std::span<const std::byte> datagram) {
                                    (void)end_->received(datagram);
                                    end_->pump();
                                  },
                              .on_path = [this](std::optional<ice::PathKind> path) { on_path(path); },
                              .relays = peer_.relays,
                              .on_unused_relay = peer_.on_unused_relay});
}

void PeerDatagrams::start() {
  if (paths_) return paths_->begin();
  has_begun_ = true;
  end_->start();
}

/// Until the first path is found, the images go over TCP. When a path is lost, the silence on it is noticed.
void PeerDatagrams::on_path(std::optional<ice::PathKind> path) {
  if (!path) return;
  if (!std::exchange(has_begun_, true)) return end_->start();
  end_->way_changed();
  if (carries_images() && peer_.on_phase) peer_.on_phase(wire::DatagramPhase::Up);
}

std::string PeerDatagrams::way() const {
  return paths_ && paths_->path() ? ice::in_words(*paths_->path(), end_->link().path().round_trip()) : std::string();
}

/// On a path that was found, the peer has answered connectivity checks from its address, and goes on to do so.
bool PeerDatagrams::is_proved() const noexcept { return paths_ || address_.is_proved(); }

/// True in each phase except Up, because TCP then carries the images and loses nothing.
bool PeerDatagrams::references_arrive() const noexcept {
  return path() == nullptr || link::references_arrive(*path(), link::DatagramLinkSettings{}.deadline);
}

const link::PathEstimate* PeerDatagrams::path() const noexcept {
  return end_->phase() == wire::DatagramPhase::Up ? &end_->link().path() : nullptr;
}

std::optional<double> PeerDatagrams::share_B_per_s() const noexcept {
  return path() != nullptr ? path()->share_B_per_s() : std::nullopt;
}

std::optional<double> PeerDatagrams::delivered_share_B_per_s() const noexcept {
  return path() != nullptr ? path()->delivered_share_B_per_s() : std::nullopt;
}

Nanoseconds PeerDatagrams::queue() const noexcept { return path() != nullptr ? path()->queue_delay() : Nanoseconds{0}; }

/// Only the newest authenticated datagram may change the address: a replayed one must not redirect the stream.
void PeerDatagrams::received(std::span<const std::byte> datagram, const DatagramPort::Endpoint& from) {
  if (end_->received(datagram).value_or(false)) prove(from, datagram.size());
  end_->pump();
}

void PeerDatagrams::prove(const DatagramPort::Endpoint& from, std::size_t bytes) {
  address_.received(from, bytes, [] {
    std::random_device random;
    return (std::uint64_t{random()} << 32U) | random();
  });
  const std::optional<std::uint64_t> nonce = end_->take_response();
  if (nonce && address_.answered(*nonce)) hub_.send_by_datagram(peer_.subscriber, carries_images());
  link::Datagram datagram;
  const std::optional<ProvedAddress::Challenge> challenge = address_.challenge(peer_.now());
  if (!challenge || !end_->challenge(challenge->nonce, datagram)) return;
  if (address_.may_send(challenge->to, datagram.bytes().size())) (void)port_.send(datagram.bytes(), challenge->to);
}

/// A datagram for an address that may get no more is lost.
bool PeerDatagrams::send(std::span<const std::byte> datagram) {
  if (paths_) return paths_->send(datagram);
  const std::optional<DatagramPort::Endpoint> to = address_.receiver();
  return !to || !address_.may_send(*to, datagram.size()) || port_.send(datagram, *to);
}

bool PeerDatagrams::carries_images() const noexcept { return end_->phase() == wire::DatagramPhase::Up && is_proved(); }

void PeerDatagrams::on_phase(wire::DatagramPhase phase) {
  hub_.send_by_datagram(peer_.subscriber, carries_images());
  if (paths_ && phase == wire::DatagramPhase::Blocked) paths_->lost();
  if (peer_.on_phase) peer_.on_phase(phase);
}

}  // namespace telepalp::hub
