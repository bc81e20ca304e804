#include "server/hub/peer.h"

#include <boost/asio/post.hpp>
#include <cmath>
#include <utility>

#include "proto/keys/audit_text.h"

namespace telepalp::hub {
namespace {

/// The operation for which a peer needs permission to take a place of `kind`.
keys::Operation operation_of(PlaceKind kind) noexcept {
  if (kind == PlaceKind::Station) return keys::Operation::Touch;
  return kind == PlaceKind::Recorder ? keys::Operation::Record : keys::Operation::Watch;
}

bool is_spoken(const std::string& topic) {
  const std::optional<wire::Topic> found = wire::find_topic(topic);
  return found && found->spoken;
}

const Error kStationNeedsKey{.what = "a station needs a key, and this program has a token, which can be copied",
                             .where = {},
                             .fix = "ask the technician for a key: telepalp-keys client --name NAME --role doctor"};

}  // namespace

Peer::Peer(const PeerSite& site, std::uint64_t number, const access::Unproven& arrival,
           std::unique_ptr<wire::ByteStream> stream, Way way)
    : site_(site),
      number_(number),
      arrival_(arrival),
      way_(way),
      touch_(site.access, number, [this](access::AuditEvent event, const std::string& more) { audit(event, more); }),
      connection_(std::make_shared<wire::Connection>(
          std::move(stream),
          wire::Connection::Options{.name = site.server_name,
                                    .role = "server",
                                    .publishes = {wire::kTopics.begin(), wire::kTopics.end()},
                                    .max_payload_bytes = kMaxUpstreamBytes,
                                    .max_read_bytes_per_s = kMaxReadBytesPerSecond},
          static_cast<wire::ConnectionOwner&>(*this))) {
  connection_->start();
}

Peer::~Peer() {
  touch_.leave(false);
  if (subscriber_) site_.hub.leave(subscriber_);
  connection_->abandon();
}

double Peer::dropped() noexcept {
  const Hub::TopicCount whole = site_.hub.topic_count(subscriber_, wire::kCameraDepth.name);
  const Hub::TopicCount window = site_.hub.topic_count(subscriber_, wire::kCameraDepthWindow.name);
  return drops_.step(whole.published + window.published, whole.dropped + window.dropped);
}

void Peer::check_key() {
  show_revocations();
  if (!who_) return;
  if (const std::optional<Error> over = site_.access.why_over(*who_)) deny(*over);
}

bool Peer::is_idle(Clock::time_point now) const noexcept {
  const auto limit = advertised_ ? site_.idle.silent : site_.idle.without_topics;
  return place_ && !subscribed_ && now - useful_ > limit;
}

bool Peer::accepts(const wire::Topic& topic) {
  const bool may = may_publish_upstream(topic) && who_ && !site_.no_stations &&
                   site_.access.may(*who_, keys::Operation::Touch) && may_be_station() &&
                   (touch_.holds() || takes_touch(false));
  if (!may) audit(access::AuditEvent::Refused, "why=" + keys::audit_text("may not publish " + std::string(topic.name)));
  advertised_ = advertised_ || may;
  return may;
}

void Peer::audit(access::AuditEvent event, const std::string& more) {
  site_.access.note(
      event, who_,
      "program=" + keys::audit_text(name_) + " from=" + connection_->peer() + (more.empty() ? "" : " " + more));
}

/// Refuses the peer with a Goodbye that tells the peer not to try again, because the attempt would fail the same way.
void Peer::deny(const Error& why) {
  audited_ = true;
  audit(access::AuditEvent::Refused, "why=" + keys::audit_text(why.what));
  site_.note_refusal(name_ + " at " + connection_->peer() + " is refused: " + why.what);
  connection_->close(to_string(why), true);
}

void Peer::refuse(const std::string& reason) {
  audit(access::AuditEvent::Refused, "why=" + keys::audit_text(reason));
  site_.note_refusal(name_ + " at " + connection_->peer() + " is refused: " + reason);
  connection_->close(reason);
}

void Peer::on_ready(const msg::Hello& peer) {
  name_ = peer.name();
  useful_ = Clock::now();
  touch_.set_run(peer.run());
  const Result<keys::Identity> who = whose(peer);
  if (!who) return deny(who.error());
  who_ = *who;
  const PlaceKind kind = place_for(peer.role());
  if (kind == PlaceKind::Station && site_.no_stations) return deny(*site_.no_stations);
  if (kind == PlaceKind::Station && !may_be_station()) return deny(kStationNeedsKey);
  if (const Result<void> may = site_.access.may(*who_, operation_of(kind)); !may) return deny(may.error());
  const std::size_t places = site_.places.of(kind);
  if (site_.taken(kind) >= places) return refuse(full_house(kind, places));
  if (const Result<void> may = site_.access.may_join(*who_); !may) return refuse(to_string(may.error()));
  if (kind == PlaceKind::Station && !takes_touch(peer.accepts_touch())) return refuse(touch_.is_held(*who_));
  join(kind, peer);
  offer_datagrams(peer);
}

Result<keys::Identity> Peer::whose(const msg::Hello& peer) const {
  const auto exporter = connection_->keying_material(keys::kTokenKeyLabel);
  const std::span<const std::byte> secret =
      exporter ? std::span<const std::byte>(*exporter) : std::span<const std::byte>();
  return site_.access.who({.is_sealed = connection_->is_sealed(),
                           .certificate = connection_->identity(),
                           .token = peer.token(),
                           .proof = {.signature = peer.token_proof(), .exporter = secret},
                           .address = access::host_of(connection_->peer())});
}

/// True if the peer has a certificate, or the server has no keys. A station moves a device at a person's hand, so a
/// token, which can be copied, is not enough.
bool Peer::may_be_station() const { return !site_.access.has_keys() || connection_->identity().has_value(); }

/// True if this peer may get what is said: its role may listen, and a recorder has stated the patient's consent.
bool Peer::may_hear() const {
  return who_ && site_.access.may(*who_, keys::Operation::Listen) &&
         (place_ != PlaceKind::Recorder || may_record_voice_);
}

/// Shows the peer the list of revoked keys, if it has not seen the newest one.
void Peer::show_revocations() {
  if (!place_ || !connection_->is_sealed() || list_shown_ == site_.access.revocation_number()) return;
  list_shown_ = site_.access.revocation_number();
  connection_->show_revocations(site_.access.revocation_list());
}

void Peer::join(PlaceKind kind, const msg::Hello& peer) {
  place_ = kind;
  may_record_voice_ = peer.voice_consent().find_first_not_of(' ') != std::string::npos;
  show_revocations();
  sender_ = site_.sender_number(peer.run());
  subscriber_ = site_.hub.join(
      name_, connection_->peer(), [this] { wake(); }, sender_);
  site_.note(name_ + " (" + (site_.access.has_keys() ? describe(*who_) : peer.role()) + ") joined from " +
             connection_->peer());
  const std::string consent = "consent=" + keys::audit_text(peer.consent().empty() ? "not stated" : peer.consent());
  std::string more = kind == PlaceKind::Viewer ? consent : "";
  if (!connection_->identity() && site_.access.has_keys()) more += (more.empty() ? "" : " ") + std::string("by=token");
  stream_ = site_.access.enter(*who_, name_, connection_->peer(), more);
  if (kind == PlaceKind::Recorder)
    audit(access::AuditEvent::Records,
          consent + (may_record_voice_ ? " voice_consent=" + keys::audit_text(peer.voice_consent()) : ""));
}

/// The datagrams' keys derive from the TLS session. Without TLS the peer is on this machine, and gets a random
/// secret.
void Peer::offer_datagrams(const msg::Hello& peer) {
  const bool finds_path = way_ == Way::MeetingPoint && peer.finds_paths();
  if (!site_.datagrams.is_open() && !finds_path) return;
  std::function<void(const msg::IcePath&)> signal;
  if (finds_path) signal = [this](const msg::IcePath& message) { connection_->find_path(message); };
  datagrams_ = PeerDatagrams::offer(site_.io, site_.datagrams, site_.hub, peer.datagrams(),
                                    connection_->keying_material(wire::kDatagramKeyLabel),
                                    {.subscriber = subscriber_,
                                     .now = [this] { return session_now(); },
                                     .on_message = messages_by_datagram(),
                                     .on_phase = [this](wire::DatagramPhase phase) { note_images(phase); },
                                     .signal = std::move(signal),
                                     .relays = site_.relays,
                                     .on_unused_relay = site_.note_relay});
  if (!datagrams_) return;
  connection_->offer_datagrams(datagrams_->message());
  datagrams_->start();
}

/// Passes a message that came by datagram to the connection, with the checks of a message over TCP. Empty for a peer
/// that may not publish.
std::function<void(wire::Message)> Peer::messages_by_datagram() {
  if (!who_ || !site_.access.may(*who_, keys::Operation::Touch)) return {};
  return [this](wire::Message message) { connection_->take_datagram(std::move(message)); };
}

void Peer::note_images(wire::DatagramPhase phase) {
  const std::string way = datagrams_ ? datagrams_->way() : std::string();
  std::string says = "no UDP datagram arrives: images go over TCP";
  if (phase == wire::DatagramPhase::Up) says = "images go by sealed datagrams" + (way.empty() ? " (UDP)" : ", " + way);
  site_.note(name_ + " at " + connection_->peer() + ": " + says);
  if (way_ == Way::MeetingPoint) site_.hub.note_way(subscriber_, "through the meeting point; " + says);
}

void Peer::wake() {
  connection_->wake();
  if (datagrams_) datagrams_->wake();
}

/// Takes the touch for this peer; false: another doctor holds it.
bool Peer::takes_touch(bool accepts) {
  const PeerTouch::Taken taken = touch_.take(*who_, accepts);
  if (taken.from) site_.hand_over(*taken.from, *who_);
  return taken.may_touch;
}

void Peer::on_hand_over(const msg::HandOver& request) {
  if (who_) connection_->hand_over(touch_.offer(*who_, request.to()));
}

void Peer::on_subscribe(std::vector<std::string> topics) {
  if (!who_ || !site_.access.may(*who_, keys::Operation::Watch)) return;
  if (subscribed_ && topics.empty()) useful_ = Clock::now();
  subscribed_ = !topics.empty();
  if (!may_hear()) std::erase_if(topics, is_spoken);
  site_.hub.subscribe(subscriber_, topics);
}

void Peer::on_message(wire::Message message) {
  useful_ = Clock::now();
  if (!touch_.renew()) return refuse(touch_.is_held(*who_));
  if (!rates_.passes(message, useful_)) return on_over_rate(message.topic);
  if (!is_valid_upstream(message)) return site_.on_invalid();
  message = with_sender(std::move(message), sender_);
  if (message.topic.name == wire::kStationWindow.name) note_window(message);
  site_.hub.publish(std::move(message));
}

/// `message` is valid, and its sender is this peer.
void Peer::note_window(const wire::Message& message) {
  msg::WindowRequest request;
  if (request.ParseFromString(*message.payload)) site_.on_window(request);
}

void Peer::on_over_rate(const wire::Topic& topic) {
  site_.on_over_rate();
  if (std::exchange(over_rate_noted_, true)) return;
  const Rate rate = upstream_rate(topic);
  site_.note(name_ + " at " + connection_->peer() + " publishes " + std::string(topic.name) + " faster than " +
             std::to_string(std::lround(rate.messages_per_s)) + " messages or " +
             std::to_string(std::lround(rate.bytes_per_s / 1024)) +
             " KiB a second: the messages beyond that are dropped. fix: let that program publish less often");
}

void Peer::on_key_frame_request(const wire::Topic& topic, SessionTime published) {
  site_.hub.request_key_frame(subscriber_, topic, published);
}

void Peer::on_closed(const std::string& reason) {
  if (place_) site_.access.leave(stream_, "why=" + keys::audit_text(reason));
  touch_.leave(reason.starts_with("peer left"));
  if (!who_ && !audited_ && site_.access.has_keys())
    audit(access::AuditEvent::Refused, "why=" + keys::audit_text(reason));
  leave_hub();
  const std::string from = connection_->peer();
  if (place_)
    site_.note(name_ + " at " + from + " disconnected: " + reason);
  else
    site_.note_stranger_gone((name_.empty() ? "a peer without a name" : name_) + " at " + from + " disconnected",
                             reason);
  site_.forget(number_);
}

void Peer::end_datagrams() {
  if (!datagrams_) return;
  datagrams_->close();
  boost::asio::post(site_.io, [ended = std::move(datagrams_)] {});  // *datagrams_ may be on the call stack
}

void Peer::leave_hub() {
  if (!subscriber_) return;
  site_.on_leaving();
  end_datagrams();
  site_.hub.leave(std::exchange(subscriber_, 0));
  sender_ = 0;  // the number is free for this peer's next connection
}

}  // namespace telepalp::hub
