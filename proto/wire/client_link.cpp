#include "proto/wire/client_link.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <limits>
#include <random>
#include <utility>

#include "proto/wire/datagram_message.h"
#include "proto/wire/datagrams/client_datagrams.h"
#include "proto/wire/datagrams/datagram_offer.h"
#include "proto/words/demand.h"
#include "proto/words/error_line.h"

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;
using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kFirstRetry = 100ms;
constexpr std::chrono::milliseconds kLongestRetry = 2s;
constexpr auto kConnectDeadline = 3s;
constexpr int kEagerProbes = 8;  // probes in quick succession, so that the clock is accurate before the first image
constexpr auto kEagerProbePeriod = 20ms;
constexpr auto kProbePeriod = 50ms;  // ten seconds of jitter of 20 ms give the clock to 1 ms

std::uint64_t random_number() {
  std::random_device random;
  return (std::uint64_t{random()} << 32U) | random();
}

std::string images_come_by(DatagramPhase phase) {
  return phase == DatagramPhase::Up ? "the images come by sealed datagrams (UDP)"
                                    : "no UDP datagram arrives: the images come over TCP";
}

/// From now on datagrams carry the topics with a deadline, or TCP does again. Messages of these topics that wait are
/// dropped: newer ones follow. Returns their number.
std::size_t send_by_datagram(SendQueue& queue, bool on) {
  const std::size_t dropped = queue.remove_if([](const Message& message) { return message.topic.has_deadline(); });
  queue.send_by_datagram(on);
  return dropped;
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
      resolver_(io),
      connecting_(io),
      retry_(io),
      probe_(io),
      back_off_(kFirstRetry),
      offset_target_ns_(SessionClock::anchored_to_wall_clock().offset().count()),
      offset_line_at_zero_ns_(std::numeric_limits<std::int64_t>::min() / 2) {}

ClientLink::~ClientLink() {
  if (connection_) connection_->abandon();
}

void ClientLink::start() {
  demand(state_ == LinkState::Stopped, "only a link that is stopped is started");
  connect();
}

void ClientLink::stop(const std::string& reason) {
  if (state_ == LinkState::Stopped) return;
  resolver_.cancel();
  error_code ignored;
  connecting_.close(ignored);
  retry_.cancel();
  probe_.cancel();
  end_datagrams();
  become(LinkState::Stopped, reason);
  if (connection_) connection_->close(reason);
}

void ClientLink::subscribe(std::vector<std::string> topics) {
  options_.subscribes = std::move(topics);
  if (connection_ && connection_->ready()) connection_->subscribe(options_.subscribes);
}

bool ClientLink::publish(Message message) {
  message.sequence = ++sequences_[message.topic.name];
  const bool connected = state_ == LinkState::Connected;
  if (!connected && !message.topic.kept_while_away) {
    ++counts_.not_sent;
    return false;
  }
  counts_.not_sent += outgoing_.push(message).size();
  if (connected) connection_->wake();
  if (datagrams_) datagrams_->wake();
  return connected;
}

void ClientLink::request_key_frame(const Message& unreadable) {
  if (connection_ && connection_->ready()) connection_->request_key_frame(unreadable);
}

bool ClientLink::hand_over(const std::string& to) {
  if (state_ != LinkState::Connected || !connection_) return false;
  msg::HandOver request;
  request.set_to(to);
  hands_over_ = true;
  connection_->hand_over(request);
  return true;
}

void ClientLink::accept_touch() {
  accepts_once_ = true;
  back_off_ = kFirstRetry;
}

void ClientLink::on_hand_over(const msg::HandOver& answer) {
  if (std::exchange(hands_over_, false) && handlers_.on_hand_over)
    handlers_.on_hand_over(answer.done(), answer.outcome());
}

SessionClock ClientLink::clock() const noexcept {
  const Nanoseconds target{offset_target_ns_.load(std::memory_order_acquire)};
  const Nanoseconds line_at_zero{offset_line_at_zero_ns_.load(std::memory_order_acquire)};
  const SlewedOffset offset{.target = target, .line_at_zero = line_at_zero};
  return SessionClock{offset.at(std::chrono::steady_clock::now().time_since_epoch())};
}

Nanoseconds ClientLink::clock_uncertainty() const noexcept {
  return clock_sync_.uncertainty(std::chrono::steady_clock::now().time_since_epoch());
}

std::map<std::string_view, ReceivedCount> ClientLink::received() const {
  std::map<std::string_view, ReceivedCount> sum = received_before_;
  if (connection_) add(sum, connection_->received());
  return sum;
}

void ClientLink::connect() {
  become(LinkState::Connecting, options_.host + ":" + std::to_string(options_.port));
  error_code not_numeric;
  const auto address = boost::asio::ip::make_address(options_.host, not_numeric);
  if (not_numeric) return resolve();
  untried_ = {{address, options_.port}};
  connect_next();
}

void ClientLink::resolve() {
  resolver_.async_resolve(options_.host, std::to_string(options_.port),
                          while_alive([this](const error_code& code, const tcp::resolver::results_type& found) {
                            if (state_ == LinkState::Stopped) return;
                            if (code) return on_connect_failed(code.message());
                            untried_.assign(found.begin(), found.end());
                            connect_next();
                          }));
}

/// Tries the next address of the host. A name may have several, for example ::1 and 127.0.0.1, and the server may
/// listen at one of them only. Without a key, nothing leaves this machine: a patient in clear text on a network is
/// worse than no connection.
void ClientLink::connect_next() {
  const tcp::endpoint endpoint = untried_.front();
  untried_.pop_front();
  if (!options_.key && !endpoint.address().is_loopback())
    return refuse({.what = "the server is on another machine, and no key is given",
                   .where = {},
                   .fix = "give --key FILE; the technician of the server makes it: telepalp-keys client"});
  server_ = endpoint;
  connecting_ = tcp::socket(io_);
  retry_.expires_after(kConnectDeadline);
  retry_.async_wait(while_alive([this](const error_code& code) {
    error_code ignored;
    if (!code) connecting_.close(ignored);
  }));
  connecting_.async_connect(endpoint, while_alive([this](const error_code& code) {
                              if (state_ == LinkState::Stopped) return;  // it may have ended before stop() was called
                              retry_.cancel();
                              if (code && !untried_.empty()) return connect_next();
                              if (code) return on_connect_failed(code.message());
                              greet(std::move(connecting_));
                            }));
}

void ClientLink::greet(tcp::socket socket) {
  Result<std::unique_ptr<ByteStream>> stream = secured(std::move(socket));
  if (!stream) return refuse(stream.error());
  ConnectionOwner& owner = *this;
  connection_ = std::make_shared<Connection>(
      std::move(stream).value(),
      Connection::Options{.name = options_.name,
                          .role = options_.role,
                          .token = options_.key ? options_.key->token : "",
                          .run = run_,
                          .datagrams = options_.datagrams ? quick_cipher() : msg::DATAGRAM_CIPHER_NONE,
                          .accepts_touch = options_.accepts_touch || accepts_once_,
                          .publishes = options_.publishes},
      owner);
  connection_->start();
}

Result<std::unique_ptr<ByteStream>> ClientLink::secured(tcp::socket socket) {
  if (!options_.key) return plain_tcp(std::move(socket));
  if (!tls_) {
    Result<TlsSettings> settings = tls_settings(keys::client_context(*options_.key));
    if (!settings) return settings.error();
    tls_ = std::move(settings).value();
  }
  return tls_at_client(std::move(socket), tls_, options_.host, options_.key);
}

void ClientLink::refuse(Error why) {
  refusal_ = std::move(why);
  refusal_.where = options_.host + ":" + std::to_string(options_.port);
  become(LinkState::Refused, refusal_.what);
}

std::optional<std::array<std::byte, 32>> ClientLink::keying_material(std::string_view label) const {
  return connection_ ? connection_->keying_material(label) : std::nullopt;
}

void ClientLink::on_connect_failed(const std::string& reason, std::optional<Error> not_served_because) {
  not_served_because_ = std::move(not_served_because);
  become(LinkState::Connecting, options_.host + ":" + std::to_string(options_.port) + ": " + reason);
  retry_later();
}

void ClientLink::retry_later() {
  retry_.expires_after(back_off_);
  back_off_ = std::min(2 * back_off_, kLongestRetry);
  retry_.async_wait(while_alive([this](const error_code& code) {
    if (!code && state_ != LinkState::Stopped) connect();  // the timer may have expired before stop() was called
  }));
}

void ClientLink::on_ready(const msg::Hello& peer) {
  peer_name_ = peer.name();
  probes_ = 0;
  clock_sync_.forget_samples();
  connection_->subscribe(options_.subscribes);
  connection_->probe_clock();
  probe_later();
}

void ClientLink::probe_later() {
  probe_.expires_after(++probes_ < kEagerProbes ? std::chrono::steady_clock::duration{kEagerProbePeriod}
                                                : std::chrono::steady_clock::duration{kProbePeriod});
  probe_.async_wait(while_alive([this](const error_code& code) {
    if (code || !connection_) return;
    probe_later();  // first, because the next line may end the connection
    connection_->probe_clock();
  }));
}

void ClientLink::on_clock(const ClockSample& sample) {
  if (!clock_sync_.add(sample)) return;
  // With this order, a reader between the two stores still sees the old target, or a line that is not above the old
  // offset.
  offset_line_at_zero_ns_.store(clock_sync_.offset()->line_at_zero.count(), std::memory_order_release);
  offset_target_ns_.store(clock_sync_.offset()->target.count(), std::memory_order_release);
  if (state_ != LinkState::Connecting) return;
  back_off_ = kFirstRetry;
  accepts_once_ = false;
  ++counts_.connections;
  not_served_because_.reset();
  become(LinkState::Connected, peer_name_ + " at " + connection_->peer());
  if (connection_) connection_->wake();
  start_datagrams();
}

void ClientLink::on_datagram_offer(const msg::DatagramOffer& offer) {
  offered_ = offer;
  start_datagrams();
}

/// Session time without the clock's steps since the datagrams began, so that a step does not change the time-outs and
/// ages that are measured by it.
SessionTime ClientLink::datagram_now() const noexcept {
  return clock().now() - (clock_sync_.stepped() - stepped_before_datagrams_);
}

/// The ages of frames need the session clock, so that datagrams begin when it is synchronised.
void ClientLink::start_datagrams() {
  if (datagrams_ || !offered_ || state_ != LinkState::Connected || !connection_) return;
  const auto seal = accept_offer(*offered_, connection_->keying_material(kDatagramKeyLabel));
  if (!seal) return;
  stepped_before_datagrams_ = clock_sync_.stepped();
  datagrams_ = std::make_unique<ClientDatagrams>(
      io_, boost::asio::ip::udp::endpoint(server_.address(), server_.port()), *seal,
      ClientDatagrams::Handlers{.next_frame = [this]() -> std::optional<link::Frame> {
                                  std::vector<Message> replaced;
                                  const std::optional<Message> message = outgoing_.pop_newest(replaced);
                                  counts_.not_sent += replaced.size();
                                  if (!message) return std::nullopt;
                                  ++counts_.published;
                                  return frame_of(*message, datagram_now());
                                },
                                .on_frame =
                                    [this](const link::Frame& frame) {
                                      std::optional<Message> message = message_of(frame);
                                      if (connection_ && message) connection_->take_datagram(std::move(*message));
                                    },
                                .on_phase =
                                    [this](DatagramPhase phase) {
                                      if (handlers_.on_datagrams) handlers_.on_datagrams(phase, images_come_by(phase));
                                    },
                                .on_carry = [this](bool on) { counts_.not_sent += send_by_datagram(outgoing_, on); },
                                .now = [this] { return datagram_now(); }});
  datagrams_->start();
}

void ClientLink::end_datagrams() {
  offered_.reset();
  if (!datagrams_) return;
  datagrams_->close();
  boost::asio::post(io_, [ended = std::move(datagrams_)] {});  // it may be on the call stack
}

DatagramPhase ClientLink::datagrams() const noexcept {
  return datagrams_ ? datagrams_->end().phase() : DatagramPhase::Off;
}

void ClientLink::change_datagram_port() {
  if (datagrams_) datagrams_->change_socket();
}

void ClientLink::on_message(Message message) {
  if (handlers_.on_message) handlers_.on_message(message);
}

void ClientLink::on_closed(const std::string& reason) {
  add(received_before_, connection_->received());
  const std::optional<Error> refusal = connection_->refusal();
  const std::optional<std::string> goodbye = connection_->peers_goodbye();
  connection_.reset();
  end_datagrams();
  probe_.cancel();
  if (std::exchange(hands_over_, false) && handlers_.on_hand_over) handlers_.on_hand_over(false, reason);
  if (state_ == LinkState::Stopped) return;
  if (refusal) return refuse(*refusal);
  if (state_ == LinkState::Connected) {
    counts_.not_sent += outgoing_.remove_if([](const Message& message) { return !message.topic.kept_while_away; });
    become(LinkState::Lost, reason);
    if (state_ == LinkState::Stopped) return;  // the handler called stop()
    become(LinkState::Connecting, options_.host + ":" + std::to_string(options_.port));
    return retry_later();
  }
  on_connect_failed(reason, goodbye ? std::optional{error_in(*goodbye)} : std::nullopt);
}

std::optional<Message> ClientLink::next_to_send() {
  std::optional<Message> message = outgoing_.pop();
  if (message) ++counts_.published;
  return message;
}

void ClientLink::become(LinkState state, const std::string& detail) {
  state_ = state;
  if (handlers_.on_state) handlers_.on_state(state, detail);
}

}  // namespace telepalp::wire
