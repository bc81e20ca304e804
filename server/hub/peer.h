#pragma once

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/access/audit_text.h"
#include "server/hub/peer_datagrams.h"
#include "server/hub/peer_listener.h"
#include "server/hub/peer_touch.h"
#include "server/hub/upstream.h"

namespace telepalp::hub {

/// One peer: connects its network connection with its subscription in the hub.
class PeerListener::Peer : public wire::ConnectionOwner {
 public:
  using Clock = std::chrono::steady_clock;

  Peer(PeerListener& listener, PeerNumber number, boost::asio::ip::tcp::socket socket)
      : listener_(listener),
        number_(number),
        touch_(access(), number, [this] { return in_audit(); }),
        connection_(std::make_shared<wire::Connection>(
            listener.stream_over(std::move(socket)),
            wire::Connection::Options{.name = listener.options_.name,
                                      .role = "server",
                                      .publishes = {wire::kTopics.begin(), wire::kTopics.end()},
                                      .max_payload_bytes = kMaxUpstreamBytes,
                                      .max_read_bytes_per_s = kMaxReadBytesPerSecond},
            *this)) {
    connection_->start();
  }
  ~Peer() override {
    touch_.leave(true);
    if (subscriber_) listener_.hub_.leave(subscriber_);
    connection_->abandon();
  }

  void close(const std::string& reason) { connection_->close(reason); }
  /// Doctor `who` at another peer has accepted the touch (the right to publish as a station) that this peer offered.
  void give_touch_to(const keys::Identity& who) { connection_->close(touch_.lose_to(who)); }
  [[nodiscard]] std::uint32_t sender() const noexcept { return sender_; }
  [[nodiscard]] std::string from() const { return connection_->peer(); }  ///< ADDRESS:PORT

  /// The kind of place (places.h: a connection that counts against a limit) that the peer occupies; nullopt: no Hello
  /// yet, or refused.
  [[nodiscard]] std::optional<PlaceKind> place() const noexcept { return place_; }

  /// Ends the connection when the peer's key has expired or is revoked.
  void check_key() {
    if (!who_ || access().still_holds(*who_)) return;
    const bool expired = who_->expires <= std::chrono::system_clock::now();
    deny({.what = "the key of " + describe(*who_) + (expired ? " has expired" : " is revoked"),
          .where = {},
          .fix = expired ? "ask the technician to renew it: telepalp-keys renew FILE"
                         : "ask the technician for a key: telepalp-keys client --name NAME --role ROLE"});
  }

  [[nodiscard]] bool references_arrive() const noexcept { return !datagrams_ || datagrams_->references_arrive(); }

  [[nodiscard]] bool is_idle(Clock::time_point now) const noexcept {
    const IdleLimits& limits = listener_.options_.idle;
    return place_ && !subscribed_ && now - useful_ > (advertised_ ? limits.silent : limits.without_topics);
  }

 private:
  access::Access& access() const { return *listener_.options_.access; }

  bool accepts(const wire::Topic& topic) override {
    const bool may = may_publish_upstream(topic) && who_ && access().may(*who_, keys::Operation::Touch) &&
                     (touch_.holds() || takes_touch(false));
    if (!may)
      access().note(access::AuditEvent::Refused,
                    in_audit() + " why=" + access::audit_text("may not publish " + std::string(topic.name)));
    advertised_ = advertised_ || may;
    return may;
  }

  [[nodiscard]] std::string in_audit() const {
    return "who=" + (who_ ? describe(*who_) : std::string("stranger")) + " program=" + access::audit_text(name_) +
           " from=" + connection_->peer() + (who_ && !who_->serial.empty() ? " key=" + who_->serial : "");
  }

  /// The operation for which a peer needs permission to take a place of `kind`.
  static keys::Operation operation_of(PlaceKind kind) noexcept {
    if (kind == PlaceKind::Station) return keys::Operation::Touch;
    return kind == PlaceKind::Recorder ? keys::Operation::Record : keys::Operation::Watch;
  }

  /// Refuses the peer with a Goodbye that tells the peer not to try again, because the attempt would fail the same way.
  void deny(const Error& why) {
    audited_ = true;
    access().note(access::AuditEvent::Refused, in_audit() + " why=" + access::audit_text(why.what));
    listener_.note_refusal(name_ + " at " + connection_->peer() + " is refused: " + why.what);
    connection_->close(to_string(why), true);
  }

  void on_ready(const msg::Hello& peer) override {
    name_ = peer.name();
    useful_ = Clock::now();
    const Result<keys::Identity> who = access().who(connection_->is_sealed(), connection_->identity(), peer.token(),
                                                    access::host_of(connection_->peer()));
    if (!who) return deny(who.error());
    who_ = *who;
    const PlaceKind kind = place_for(peer.role());
    if (const Result<void> may = access().may(*who_, operation_of(kind)); !may) return deny(may.error());
    const std::size_t places = listener_.options_.places.of(kind);
    if (listener_.taken(kind) >= places) return refuse(full_house(kind, places));
    if (kind == PlaceKind::Station && !takes_touch(peer.accepts_touch())) return refuse(touch_.is_held(*who_));
    place_ = kind;
    sender_ = listener_.sender_number(peer.run());
    subscriber_ = listener_.hub_.join(
        name_, connection_->peer(), [this] { wake(); }, sender_);
    listener_.note(name_ + " (" + (access().has_keys() ? describe(*who_) : peer.role()) + ") joined from " +
                   connection_->peer());
    access().note(access::AuditEvent::Joined, in_audit());
    if (kind == PlaceKind::Recorder) access().note(access::AuditEvent::Records, in_audit());
    offer_datagrams(peer.datagrams());
  }
  /// The datagrams' keys derive from the TLS session. Without TLS the peer is on this machine, and gets a random
  /// secret.
  void offer_datagrams(msg::DatagramCipher wanted) {
    if (!listener_.datagrams_->is_open()) return;
    datagrams_ = PeerDatagrams::offer(listener_.io_, *listener_.datagrams_, listener_.hub_, wanted,
                                      connection_->keying_material(wire::kDatagramKeyLabel),
                                      {.subscriber = subscriber_,
                                       .now = [this] { return session_now(); },
                                       .on_message = messages_by_datagram(),
                                       .on_phase = [this](wire::DatagramPhase phase) { note_images(phase); }});
    if (!datagrams_) return;
    connection_->offer_datagrams(datagrams_->message());
    datagrams_->start();
  }
  /// Passes a message that came by datagram to the connection, with the checks of a message over TCP. Empty for a peer
  /// that may not publish.
  std::function<void(wire::Message)> messages_by_datagram() {
    if (!who_ || !access().may(*who_, keys::Operation::Touch)) return {};
    return [this](wire::Message message) { connection_->take_datagram(std::move(message)); };
  }
  void note_images(wire::DatagramPhase phase) {
    listener_.note(name_ + " at " + connection_->peer() +
                   (phase == wire::DatagramPhase::Up ? ": images go by sealed datagrams (UDP)"
                                                     : ": no UDP datagram arrives: images go over TCP"));
  }
  void wake() {
    connection_->wake();
    if (datagrams_) datagrams_->wake();
  }
  /// Takes the touch for this peer; false: another doctor holds it.
  bool takes_touch(bool accepts) {
    const PeerTouch::Taken taken = touch_.take(*who_, accepts);
    const auto before = taken.from ? listener_.peers_.find(*taken.from) : listener_.peers_.end();
    if (before != listener_.peers_.end()) before->second->give_touch_to(*who_);
    return taken.may_touch;
  }
  void on_hand_over(const msg::HandOver& request) override {
    if (who_) connection_->hand_over(touch_.offer(*who_, request.to()));
  }
  void refuse(const std::string& reason) {
    access().note(access::AuditEvent::Refused, in_audit() + " why=" + access::audit_text(reason));
    listener_.note_refusal(name_ + " at " + connection_->peer() + " is refused: " + reason);
    connection_->close(reason);
  }
  void on_subscribe(std::vector<std::string> topics) override {
    if (!who_ || !access().may(*who_, keys::Operation::Watch)) return;
    if (subscribed_ && topics.empty()) useful_ = Clock::now();
    subscribed_ = !topics.empty();
    listener_.hub_.subscribe(subscriber_, topics);
  }
  void on_message(wire::Message message) override {
    useful_ = Clock::now();
    if (!touch_.renew()) return refuse(touch_.is_held(*who_));
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
                   " KiB a second: the messages beyond that are dropped. fix: let that program publish less often");
  }
  void on_key_frame_request(const wire::Topic& topic, SessionTime published) override {
    listener_.hub_.request_key_frame(subscriber_, topic, published);
  }
  void on_clock(const wire::ClockSample&) override {}  // the server's clock is the session clock: it sends no probes
  void on_closed(const std::string& reason) override {
    if (place_) access().note(access::AuditEvent::Left, in_audit() + " why=" + access::audit_text(reason));
    touch_.leave(reason.starts_with("peer left"));
    if (!who_ && !audited_ && access().has_keys())
      access().note(access::AuditEvent::Refused, in_audit() + " why=" + access::audit_text(reason));
    leave_hub();
    listener_.note((name_.empty() ? "a peer without a name" : name_) + " at " + connection_->peer() +
                   " disconnected: " + reason);
    listener_.forget(number_);
  }
  std::optional<wire::Message> next_to_send() override { return listener_.hub_.next(subscriber_); }
  SessionTime session_now() override { return listener_.clock_.now(); }

  void end_datagrams() {
    if (!datagrams_) return;
    datagrams_->close();
    boost::asio::post(listener_.io_, [ended = std::move(datagrams_)] {});  // *datagrams_ may be on the call stack
  }
  void leave_hub() {
    if (!subscriber_) return;
    if (listener_.options_.on_leaving) listener_.options_.on_leaving();
    end_datagrams();
    listener_.hub_.leave(std::exchange(subscriber_, 0));
    sender_ = 0;  // the number is free for this peer's next connection
  }

  PeerListener& listener_;
  PeerNumber number_;
  std::string name_;
  std::optional<keys::Identity> who_;  // nullopt: not known yet, or refused
  std::optional<PlaceKind> place_;
  PeerTouch touch_;
  bool audited_ = false;        // the audit log already has the reason for this peer's refusal
  bool advertised_ = false;     // the peer has advertised an allowed topic
  bool subscribed_ = false;     // the peer is subscribed to at least one topic
  Clock::time_point useful_{};  // when it last published, ended its subscriptions or sent its Hello
  UpstreamRates rates_;
  bool over_rate_noted_ = false;
  std::uint32_t sender_ = 0;                      // 0: no Hello yet
  SubscriberId subscriber_ = 0;                   // 0: not in the hub
  std::unique_ptr<PeerDatagrams> datagrams_;      // null: not offered
  std::shared_ptr<wire::Connection> connection_;  // shared with its pending operations
};

}  // namespace telepalp::hub
