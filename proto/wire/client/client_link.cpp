#include "proto/wire/client/client_link.h"

#include <boost/asio/post.hpp>
#include <random>
#include <utility>

#include "proto/wire/datagram_message.h"
#include "proto/wire/datagrams/client_datagrams.h"
#include "proto/wire/datagrams/datagram_offer.h"
#include "proto/wire/datagrams/images_way.h"
#include "proto/wire/sockets/udp_socket.h"
#include "proto/words/demand.h"
#include "proto/words/error_line.h"

namespace telepalp::wire {
namespace {

std::uint64_t random_number() {
  std::random_device random;
  return (std::uint64_t{random()} << 32U) | random();
}

void add(std::map<std::string_view, ReceivedCount>& sum, const std::map<std::string_view, ReceivedCount>& counts) {
  for (const auto& [topic, count] : counts) {
    sum[topic].messages += count.messages;
    sum[topic].missed += count.missed;
  }
}

}  // namespace

std::string_view name(LinkState state) noexcept {
  switch (state) {
    case LinkState::Connecting:
      return "connecting";
    case LinkState::Connected:
      return "connected";
    case LinkState::Lost:
      return "lost";
    case LinkState::Refused:
      return "refused";
    case LinkState::Stopped:
      return "stopped";
  }
  return "?";
}

ClientLink::ClientLink(boost::asio::io_context& io, Options options, Handlers handlers)
    : io_(io),
      options_(std::move(options)),
      handlers_(std::move(handlers)),
      run_(random_number()),
      dialer_(io, {.host = options_.host, .port = options_.port, .site = options_.site, .key = options_.key},
              {.on_connected =
                   [this](std::unique_ptr<ByteStream> stream, const Dialer::Endpoint& server) {
                     server_ = server;
                     greet(std::move(stream));
                   },
               .on_failed = [this](const std::string& reason) { on_connect_failed(reason); },
               .on_refused = [this](const Error& why) { refuse(why); }}),
      back_off_(io),
      prober_(io) {
  if (options_.key) revoked_.known.emplace(*options_.key);
}

ClientLink::~ClientLink() {
  if (connection_) connection_->abandon();
}

void ClientLink::start() {
  demand(state_ == LinkState::Stopped, "only a link that is stopped is started");
  connect();
}

void ClientLink::stop(const std::string& reason) {
  if (state_ == LinkState::Stopped) return;
  dialer_.hang_up();
  back_off_.cancel();
  prober_.stop();
  end_datagrams();
  become(LinkState::Stopped, reason);
  if (connection_) connection_->close(reason);
}

void ClientLink::subscribe(std::vector<std::string> topics) {
  options_.subscribes = std::move(topics);
  if (connection_ && connection_->ready()) connection_->subscribe(options_.subscribes);
}

bool ClientLink::publish(Message message) {
  const bool connected = state_ == LinkState::Connected;
  if (!outbox_.put(std::move(message), connected)) return false;
  if (connected) connection_->wake();
  if (datagrams_.carrier) datagrams_.carrier->wake();
  return connected;
}

void ClientLink::request_key_frame(const Message& unreadable) {
  if (connection_ && connection_->ready()) connection_->request_key_frame(unreadable);
}

bool ClientLink::hand_over(const std::string& to) {
  if (state_ != LinkState::Connected || !connection_) return false;
  msg::HandOver request;
  request.set_to(to);
  touch_.hands_over = true;
  connection_->hand_over(request);
  return true;
}

void ClientLink::accept_touch() {
  touch_.accepts_once = true;
  back_off_.succeeded();
}

void ClientLink::on_hand_over(const msg::HandOver& answer) {
  if (std::exchange(touch_.hands_over, false) && handlers_.on_hand_over)
    handlers_.on_hand_over(answer.done(), answer.outcome());
}

std::map<std::string_view, ReceivedCount> ClientLink::received() const {
  std::map<std::string_view, ReceivedCount> sum = received_before_;
  if (connection_) add(sum, connection_->received());
  return sum;
}

void ClientLink::connect() {
  become(LinkState::Connecting, dialer_.server());
  if (state_ != LinkState::Stopped) dialer_.dial();  // the handler may have called stop()
}

void ClientLink::greet(std::unique_ptr<ByteStream> stream) {
  ConnectionOwner& owner = *this;
  revoked_.parts.clear();
  revoked_.shown = false;
  connection_ = std::make_shared<Connection>(
      std::move(stream),
      Connection::Options{.name = options_.name,
                          .role = options_.role,
                          .token = options_.key ? options_.key->token : "",
                          .consent = options_.consent.substr(0, 512),
                          .voice_consent = options_.voice_consent.substr(0, 512),
                          .run = run_,
                          .datagrams = options_.datagrams ? quick_cipher() : msg::DATAGRAM_CIPHER_NONE,
                          .finds_paths = options_.datagrams && options_.key,
                          .accepts_touch = options_.accepts_touch || touch_.accepts_once,
                          .publishes = options_.publishes},
      owner);
  connection_->start();
}

void ClientLink::refuse(Error why) {
  refusal_ = std::move(why);
  refusal_.where = dialer_.server();
  become(LinkState::Refused, refusal_.what);
}

std::optional<std::array<std::byte, 32>> ClientLink::keying_material(std::string_view label) const {
  return connection_ ? connection_->keying_material(label) : std::nullopt;
}

void ClientLink::on_connect_failed(const std::string& reason, std::optional<Error> not_served_because) {
  not_served_because_ = std::move(not_served_because);
  failed_because_ = reason;
  become(LinkState::Connecting, dialer_.server() + ": " + reason);
  retry_later();
}

void ClientLink::retry_later() {
  back_off_.retry([this] {
    if (state_ != LinkState::Stopped) connect();  // a handler may have called stop() before the timer was started
  });
}

void ClientLink::on_ready(const msg::Hello& peer) {
  peer_name_ = peer.name();
  clock_.forget_samples();
  connection_->subscribe(options_.subscribes);
  prober_.start([this] {
    if (connection_ && !dialer_.has_own_address()) return own_address_lost();
    if (connection_) connection_->probe_clock();
  });
}

/// A new connection from the new address is there sooner than the silence on the old one is noticed.
void ClientLink::own_address_lost() {
  connection_->abandon();
  on_closed("this computer's address has changed");
}

void ClientLink::on_revocation_list(const msg::RevocationList& list) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  if (!revoked_.known || revoked_.parts.size() + list.part().size() > kMostBytes) return;
  revoked_.parts += list.part();
  if (!list.last()) return;
  const Result<void> taken = revoked_.known->take(std::exchange(revoked_.parts, {}));
  revoked_.shown = taken.ok();
  if (!taken) revoked_.why_not_trusted = taken.error();
  (void)trusts_server();
}

/// Ends the connection to a server whose key is revoked, or that shows no valid list of revoked keys. The list comes
/// before the first sample of the clock.
bool ClientLink::trusts_server() {
  const std::optional<keys::ServerCertificate> server = connection_->server_certificate();
  if (!revoked_.known || !server) return true;
  const Result<void> trusted = revoked_.known->check(*server, revoked_.shown);
  if (!trusted && !revoked_.why_not_trusted) revoked_.why_not_trusted = trusted.error();
  if (revoked_.why_not_trusted) connection_->close("this client does not trust the server's key");
  return !revoked_.why_not_trusted;
}

void ClientLink::on_clock(const ClockSample& sample) {
  if (!clock_.add(sample) || state_ != LinkState::Connecting || !trusts_server()) return;
  back_off_.succeeded();
  touch_.accepts_once = false;
  ++connections_;
  not_served_because_.reset();
  become(LinkState::Connected, peer_name_ + " at " + connection_->peer());
  if (connection_) connection_->wake();
  start_datagrams();
}

void ClientLink::on_datagram_offer(const msg::DatagramOffer& offer) {
  datagrams_.offer = offer;
  if (offer.finds_path()) find_paths();
  start_datagrams();
}

/// Session time without the clock's steps since the datagrams began, so that a step does not change the time-outs and
/// ages that are measured by it.
SessionTime ClientLink::datagram_now() const noexcept {
  return clock().now() - (clock_.stepped() - datagrams_.stepped_before);
}

/// The ages of frames need the session clock, so that datagrams begin when it is synchronised.
void ClientLink::start_datagrams() {
  if (datagrams_.carrier || !datagrams_.offer || state_ != LinkState::Connected || !connection_) return;
  const auto seal = accept_offer(*datagrams_.offer, connection_->keying_material(kDatagramKeyLabel));
  if (!seal) return;
  datagrams_.stepped_before = clock_.stepped();
  ClientDatagrams::Handlers handlers{.next_frame = [this](Wanted wanted) -> std::shared_ptr<const link::SharedFrame> {
                                       const std::optional<Message> message = outbox_.next_for_datagram(wanted);
                                       if (!message) return nullptr;
                                       return frame_of(*message, datagram_now());
                                     },
                                     .on_frame =
                                         [this](const link::Frame& frame) {
                                           std::optional<Message> message = message_of(frame);
                                           if (connection_ && message) connection_->take_datagram(std::move(*message));
                                         },
                                     .on_phase =
                                         [this](DatagramPhase phase) {
                                           if (handlers_.on_datagrams)
                                             handlers_.on_datagrams(phase, images_come_by(phase));
                                         },
                                     .on_carry = [this](bool on) { outbox_.send_by_datagram(on); },
                                     .now = [this] { return datagram_now(); }};
  if (datagrams_.paths)
    handlers.send = [this](std::span<const std::byte> datagram) { return datagrams_.paths->send(datagram); };
  datagrams_.carrier = std::make_unique<ClientDatagrams>(
      io_, boost::asio::ip::udp::endpoint(server_.address(), server_.port()), *seal, std::move(handlers));
  if (!datagrams_.paths) datagrams_.carrier->start();
  if (path()) on_path(path());
}

void ClientLink::find_paths() {
  datagrams_.paths = std::make_unique<ice::IcePaths>(
      io_.get_executor(),
      ice::IcePaths::Settings{.end = ice::IcePaths::End::Client,
                              .type_of_service = type_of_service(TrafficClass::Touch)},
      ice::IcePaths::Handlers{.signal =
                                  [this](const msg::IcePath& message) {
                                    if (connection_) connection_->find_path(message);
                                  },
                              .on_datagram =
                                  [this](std::span<const std::byte> datagram) {
                                    if (datagrams_.carrier) datagrams_.carrier->received(datagram);
                                  },
                              .on_path = [this](std::optional<ice::PathKind> path) { on_path(path); },
                              .on_unused_relay = [this](const Error& why) { notice(to_string(why)); }});
}

void ClientLink::notice(const std::string& text) {
  if (noticed_.is_new(text) && handlers_.on_notice) handlers_.on_notice(text);
}

void ClientLink::on_ice_path(const msg::IcePath& message) {
  if (!datagrams_.paths) return;
  datagrams_.paths->heard(message);
  const bool found_none = message.verdict() == msg::IcePath::VERDICT_DROPPED && !datagrams_.has_begun && !path();
  if (found_none && !std::exchange(datagrams_.said_no_path, true) && handlers_.on_datagrams)
    handlers_.on_datagrams(DatagramPhase::Blocked, images_come_by(DatagramPhase::Blocked));
}

/// Until the first path is found, the images come over TCP. When a path is lost, the silence on it is noticed.
void ClientLink::on_path(std::optional<ice::PathKind> path) {
  if (!path || !datagrams_.carrier) return;
  if (!std::exchange(datagrams_.has_begun, true)) return datagrams_.carrier->start();
  datagrams_.carrier->way_changed();
  if (datagrams() == DatagramPhase::Up && handlers_.on_datagrams)
    handlers_.on_datagrams(DatagramPhase::Up, images_come_by(DatagramPhase::Up));
}

std::string ClientLink::images_come_by(DatagramPhase phase) const {
  return phase == DatagramPhase::Up ? images_come_by_datagram(way()) : images_come_over_tcp();
}

std::string ClientLink::way() const {
  if (!path() || !datagrams_.carrier) return {};
  return in_words(*path(), datagrams_.carrier->end().link().path().round_trip());
}

std::optional<ice::PathKind> ClientLink::path() const noexcept {
  return datagrams_.paths ? datagrams_.paths->path() : std::nullopt;
}

void ClientLink::end_datagrams() {
  datagrams_.offer.reset();
  datagrams_.has_begun = datagrams_.said_no_path = false;
  if (datagrams_.carrier) datagrams_.carrier->close();
  if (datagrams_.paths) datagrams_.paths->close();
  // They may be on the call stack, so they are destroyed later.
  boost::asio::post(io_, [carrier = std::move(datagrams_.carrier), paths = std::move(datagrams_.paths)] {});
}

DatagramPhase ClientLink::datagrams() const noexcept {
  if (!datagrams_.carrier || (datagrams_.paths && !datagrams_.has_begun)) return DatagramPhase::Off;
  return datagrams_.carrier->end().phase();
}

void ClientLink::change_datagram_port() {
  if (datagrams_.carrier) datagrams_.carrier->change_socket();
}

void ClientLink::on_message(Message message) {
  if (handlers_.on_message) handlers_.on_message(message);
}

void ClientLink::on_closed(const std::string& reason) {
  add(received_before_, connection_->received());
  const std::optional<Error> untrusted = std::exchange(revoked_.why_not_trusted, std::nullopt);
  const std::optional<Error> refusal = untrusted ? untrusted : connection_->refusal();
  const std::optional<std::string> goodbye = connection_->peers_goodbye();
  connection_.reset();
  end_datagrams();
  prober_.stop();
  if (std::exchange(touch_.hands_over, false) && handlers_.on_hand_over) handlers_.on_hand_over(false, reason);
  if (state_ == LinkState::Stopped) return;
  if (refusal) return refuse(*refusal);
  if (state_ == LinkState::Connected) {
    outbox_.connection_lost();
    become(LinkState::Lost, reason);
    if (state_ == LinkState::Stopped) return;  // the handler called stop()
    become(LinkState::Connecting, dialer_.server());
    return retry_later();
  }
  on_connect_failed(reason, goodbye ? std::optional{error_in(*goodbye)} : std::nullopt);
}

void ClientLink::become(LinkState state, const std::string& detail) {
  state_ = state;
  if (handlers_.on_state) handlers_.on_state(state, detail);
}

}  // namespace telepalp::wire
