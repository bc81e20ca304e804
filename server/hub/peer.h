#pragma once

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/hub/peer_listener.h"
#include "server/hub/upstream.h"

namespace telepalp::server {

/// One peer: connects its network connection with its subscription in the hub.
class PeerListener::Peer : public wire::ConnectionOwner {
 public:
  using Clock = std::chrono::steady_clock;

  Peer(PeerListener& listener, PeerNumber number, boost::asio::ip::tcp::socket socket)
      : listener_(listener),
        number_(number),
        connection_(std::make_shared<wire::Connection>(
            wire::plain_tcp(std::move(socket)),
            wire::Connection::Options{.name = listener.options_.name,
                                      .role = "server",
                                      .publishes = {wire::kTopics.begin(), wire::kTopics.end()},
                                      .max_payload_bytes = kMaxUpstreamBytes,
                                      .max_read_bytes_per_s = kMaxReadBytesPerSecond},
            *this)) {
    connection_->start();
  }
  ~Peer() override {
    if (subscriber_) listener_.hub_.leave(subscriber_);
    connection_->abandon();
  }

  void close(const std::string& reason) { connection_->close(reason); }
  [[nodiscard]] std::uint32_t sender() const noexcept { return sender_; }

  /// The kind of place that the peer occupies; nullopt: no Hello yet, or refused.
  [[nodiscard]] std::optional<PlaceKind> place() const noexcept { return place_; }

  [[nodiscard]] bool is_idle(Clock::time_point now) const noexcept {
    const IdleLimits& limits = listener_.options_.idle;
    return place_ && !subscribed_ && now - useful_ > (advertised_ ? limits.silent : limits.without_topics);
  }

 private:
  bool accepts(const wire::Topic& topic) override {
    advertised_ = advertised_ || may_publish_upstream(topic);
    return may_publish_upstream(topic);
  }

  void on_ready(const msg::Hello& peer) override {
    name_ = peer.name();
    useful_ = Clock::now();
    const PlaceKind kind = place_for(peer.role());
    const std::size_t places = listener_.options_.places.of(kind);
    if (listener_.taken(kind) >= places) return refuse(full_house(kind, places));
    place_ = kind;
    sender_ = listener_.sender_number(peer.run());
    subscriber_ = listener_.hub_.join(
        name_, connection_->peer(), [this] { connection_->wake(); }, sender_);
    listener_.note(name_ + " (" + peer.role() + ") joined from " + connection_->peer());
  }
  void refuse(const std::string& reason) {
    listener_.note_refusal(name_ + " at " + connection_->peer() + " is refused: " + reason);
    connection_->close(reason);
  }
  void on_subscribe(std::vector<std::string> topics) override {
    if (subscribed_ && topics.empty()) useful_ = Clock::now();
    subscribed_ = !topics.empty();
    listener_.hub_.subscribe(subscriber_, topics);
  }
  void on_message(wire::Message message) override {
    useful_ = Clock::now();
    if (!rates_.passes(message, useful_)) return on_over_rate(message.topic);
    if (is_valid_upstream(message)) return listener_.hub_.publish(with_sender(std::move(message), sender_));
    ++listener_.counts_.invalid_messages;
  }
  void on_over_rate(const wire::Topic& topic) {
    ++listener_.counts_.over_rate;
    if (std::exchange(over_rate_noted_, true)) return;
    const Rate rate = upstream_rate(topic);
    listener_.note(name_ + " at " + connection_->peer() + " publishes " + std::string(topic.name) + " faster than " +
                   std::to_string(std::lround(rate.messages_per_s)) + " messages or " +
                   std::to_string(std::lround(rate.bytes_per_s / 1024)) +
                   " KiB a second: the messages beyond that are dropped");
  }
  void on_key_frame_request(const wire::Topic& topic, SessionTime published) override {
    listener_.hub_.request_key_frame(subscriber_, topic, published);
  }
  void on_clock(const wire::ClockSample&) override {}  // the server's clock is the session clock: it sends no probes
  void on_closed(const std::string& reason) override {
    leave_hub();
    listener_.note((name_.empty() ? "a stranger" : name_) + " at " + connection_->peer() + " left: " + reason);
    listener_.forget(number_);
  }
  std::optional<wire::Message> next_to_send() override { return listener_.hub_.next(subscriber_); }
  SessionTime session_now() override { return listener_.clock_.now(); }

  void leave_hub() {
    if (!subscriber_) return;
    if (listener_.options_.on_leaving) listener_.options_.on_leaving();
    listener_.hub_.leave(std::exchange(subscriber_, 0));
    sender_ = 0;  // the number is free for this peer's next connection
  }

  PeerListener& listener_;
  PeerNumber number_;
  std::string name_;
  std::optional<PlaceKind> place_;
  bool advertised_ = false;     // the peer has advertised an allowed topic
  bool subscribed_ = false;     // the peer is subscribed to at least one topic
  Clock::time_point useful_{};  // when it last published, subscribed or greeted
  UpstreamRates rates_;
  bool over_rate_noted_ = false;
  std::uint32_t sender_ = 0;                      // 0: no Hello yet
  SubscriberId subscriber_ = 0;                   // 0: not in the hub
  std::shared_ptr<wire::Connection> connection_;  // shared with its pending operations
};

}  // namespace telepalp::server
