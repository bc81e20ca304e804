#include "proto/wire/connection/connection.h"

#include <algorithm>
#include <utility>

#include "proto/keys/token.h"
#include "proto/wire/connection/bad_peer.h"
#include "proto/words/error_line.h"

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMaxHelloBytes = 4096;
constexpr int kMaxSubscriptions = 64;
constexpr std::size_t kMaxNameBytes = 128;
constexpr std::size_t kMaxTokenBytes = 512;
constexpr std::size_t kMaxReasonBytes = 512;
constexpr std::size_t kMaxIcePathBytes = 8 << 10;
constexpr std::size_t kRevocationPartBytes = 12 << 10;
constexpr auto kLinger = 500ms;

Error other_version(const std::string& detail) {
  return {.what = "the program at this port is no telepalp-server, or one of another version: " + detail,
          .where = {},
          .fix =
              "connect to the server's --port, not to its --http-port, and install the same version of telepalp at "
              "both ends; --version prints the version of a program"};
}

Error final_goodbye(const std::string& reason) {
  Error error = error_in(reason);
  error.what = "the server refuses: " + error.what;
  return error;
}

msg::Control hello(const Connection::Options& options) {
  msg::Control control;
  control.mutable_hello()->set_protocol(kOldestProtocolVersion);
  control.mutable_hello()->set_newest_protocol(kProtocolVersion);
  control.mutable_hello()->set_name(options.name);
  control.mutable_hello()->set_role(options.role);
  control.mutable_hello()->set_run(options.run);
  control.mutable_hello()->set_consent(options.consent);
  control.mutable_hello()->set_voice_consent(options.voice_consent);
  control.mutable_hello()->set_datagrams(options.datagrams);
  control.mutable_hello()->set_accepts_touch(options.accepts_touch);
  control.mutable_hello()->set_finds_paths(options.finds_paths);
  return control;
}

}  // namespace

Connection::Connection(std::unique_ptr<ByteStream> stream, Options options, ConnectionOwner& owner)
    : stream_(std::move(stream)),
      options_(std::move(options)),
      owner_(&owner),
      deadline_(stream_->executor()),
      read_again_(stream_->executor()),
      pace_(options_.max_read_bytes_per_s),
      parser_(kMaxHelloBytes),
      outgoing_(options_.publishes, [this] { return owner_->session_now(); }) {}

void Connection::start() {
  watch(kHandshakeDeadline, "no Hello message (the greeting of a telepalp program) arrived within 5 s");
  if (options_.token.empty()) {
    say_hello();
    return read();
  }
  // An empty write ends after the TLS handshake. Only then do both ends share the bytes that the token's proof signs.
  stream_->async_write({}, [self = shared_from_this()](const boost::system::error_code& code, std::size_t) {
    if (self->phase_ == Phase::Closed) return;
    if (code) return self->on_lost(code);
    self->say_hello();
    self->read();
  });
}

void Connection::say_hello() {
  msg::Control control = hello(options_);
  const auto exporter = stream_->keying_material(keys::kTokenKeyLabel);
  const keys::ProvedToken proved = exporter ? keys::prove_token(options_.token, *exporter) : keys::ProvedToken{};
  control.mutable_hello()->set_token(exporter ? proved.token : options_.token);
  control.mutable_hello()->set_token_proof(proved.proof);
  send(std::move(control));
  send(outgoing_.advertise());
}

void Connection::show_revocations(std::string_view list) {
  while (!list.empty()) {
    const std::string_view part = list.substr(0, kRevocationPartBytes);
    list.remove_prefix(part.size());
    msg::Control control;
    control.mutable_revocation_list()->set_part(std::string(part));
    control.mutable_revocation_list()->set_last(list.empty());
    send(std::move(control));
  }
}

void Connection::wake() { write(); }

void Connection::subscribe(const std::vector<std::string>& topics) {
  msg::Control control;
  control.mutable_subscribe();  // the field must be present even with an empty list
  for (const std::string& topic : topics) control.mutable_subscribe()->add_topics(topic);
  channels_.forget_sequences();
  send(std::move(control));
}

void Connection::probe_clock() {
  msg::Control control;
  control.mutable_clock_probe();
  send(std::move(control));
}

void Connection::request_key_frame(const Message& unreadable) {
  msg::Control control;
  control.mutable_key_frame_request()->set_topic(std::string(unreadable.topic.name));
  control.mutable_key_frame_request()->set_published_ns(to_nanoseconds(unreadable.published));
  send(std::move(control));
}

void Connection::offer_datagrams(const msg::DatagramOffer& offer) {
  msg::Control control;
  *control.mutable_datagram_offer() = offer;
  send(std::move(control));
}

void Connection::find_path(const msg::IcePath& message) {
  msg::Control control;
  *control.mutable_ice_path() = message;
  send(std::move(control));
}

void Connection::hand_over(const msg::HandOver& request) {
  msg::Control control;
  *control.mutable_hand_over() = request;
  send(std::move(control));
}

void Connection::take_datagram(Message message) {
  if (phase_ != Phase::Open) return;
  if (std::optional<Message> taken = channels_.take_datagram(std::move(message))) owner_->on_message(std::move(*taken));
}

void Connection::close(const std::string& reason, bool final) {
  farewell_.is_final = final;
  farewell_.after_messages = phase_ == Phase::Open;
  leave(reason);
}

void Connection::leave(const std::string& reason) {
  if (phase_ == Phase::Leaving || phase_ == Phase::Closed) return;
  phase_ = Phase::Leaving;
  farewell_.reason = reason;
  watch(kLinger, reason);
  write();
}

void Connection::abandon() noexcept {
  owner_ = nullptr;
  finish("");
}

void Connection::finish(const std::string& reason) noexcept {
  if (phase_ == Phase::Closed) return;
  phase_ = Phase::Closed;
  deadline_.cancel();
  read_again_.cancel();
  stream_->close();
  if (ConnectionOwner* owner = std::exchange(owner_, nullptr)) owner->on_closed(reason);
}

void Connection::on_lost(const boost::system::error_code& code) noexcept {
  if (phase_ == Phase::Greeting) refusal_ = stream_->refusal(code);
  finish(phase_ == Phase::Leaving ? farewell_.reason : "the connection ended unexpectedly: " + code.message());
}

void Connection::watch(std::chrono::steady_clock::duration patience, std::string reason) {
  deadline_.expires_after(patience);
  deadline_.async_wait([self = shared_from_this(), reason = std::move(reason)](const boost::system::error_code& code) {
    if (code) return;
    if (self->phase_ == Phase::Leaving) return self->finish(reason);
    self->leave(reason);
  });
}

void Connection::read() {
  stream_->async_read_some(boost::asio::buffer(incoming_),
                           [self = shared_from_this()](const boost::system::error_code& code, std::size_t bytes) {
                             if (self->phase_ == Phase::Closed) return;
                             if (code) return self->on_lost(code);
                             self->on_bytes({self->incoming_.data(), bytes});
                             if (self->phase_ != Phase::Closed) self->read_when_due(bytes);
                           });
}

void Connection::read_when_due(std::size_t bytes_before) {
  const auto now = std::chrono::steady_clock::now();
  const auto due = pace_.next(bytes_before, now);
  if (due <= now) return read();
  read_again_.expires_at(due);
  read_again_.async_wait([self = shared_from_this()](const boost::system::error_code& cancelled) {
    if (!cancelled && self->phase_ != Phase::Closed) self->read();
  });
}

void Connection::on_bytes(std::span<const std::byte> bytes) {
  while (phase_ == Phase::Greeting || phase_ == Phase::Open) {
    Result<std::optional<Frame>> frame = parser_.next(bytes);
    if (!frame) {
      if (phase_ == Phase::Greeting && parser_.met_other_version()) refusal_ = other_version(frame.error().what);
      return leave(stream_->peer() + ": " + to_string(frame.error()));
    }
    if (!*frame) return;
    const Result<void> taken = on_frame(std::move(**frame));
    if (!taken) return leave(stream_->peer() + ": " + to_string(taken.error()));
  }
}

Result<void> Connection::on_frame(Frame frame) {
  const bool is_control = frame.header.kind == FrameKind::Control;
  if (!is_control && phase_ == Phase::Greeting) return bad_peer("sends data before its Hello message");
  if (phase_ == Phase::Open) watch(kSilenceDeadline, "no message arrived for 5 s");
  return is_control ? on_control(frame) : on_data(std::move(frame));
}

Result<void> Connection::on_control(const Frame& frame) {
  msg::Control control;
  if (!control.ParseFromString(frame.payload)) return bad_peer("sends a damaged control message");
  if (phase_ == Phase::Greeting && !control.has_hello() && !control.has_goodbye())
    return bad_peer("does not begin with a Hello message");
  switch (control.kind_case()) {
    case msg::Control::kHello:
      return on_hello(control.hello());
    case msg::Control::kAdvertise:
      return channels_.advertise(control.advertise(), [this](const Topic& topic) { return owner_->accepts(topic); });
    case msg::Control::kSubscribe:
      return on_subscription(control.subscribe());
    case msg::Control::kClockProbe: {
      msg::Control answer;
      answer.mutable_clock_reply()->set_asked_ns(control.clock_probe().asked_ns());
      answer.mutable_clock_reply()->set_received_ns(static_cast<std::uint64_t>(to_nanoseconds(owner_->session_now())));
      send(std::move(answer));
      return {};
    }
    case msg::Control::kClockReply:
      if (const auto sample =
              outgoing_.sample(control.clock_reply(), std::chrono::steady_clock::now().time_since_epoch()))
        owner_->on_clock(*sample);
      return {};
    case msg::Control::kKeyFrameRequest:
      if (const std::optional<Topic> topic = find_topic(control.key_frame_request().topic()))
        owner_->on_key_frame_request(*topic, session_time(control.key_frame_request().published_ns()));
      return {};
    case msg::Control::kDatagramOffer:
      return on_datagram_offer(control.datagram_offer());
    case msg::Control::kHandOver:
      return on_hand_over(control.hand_over());
    case msg::Control::kIcePath:
      return on_ice_path(control.ice_path());
    case msg::Control::kRevocationList:
      owner_->on_revocation_list(control.revocation_list());
      return {};
    case msg::Control::kGoodbye:
      peers_goodbye_ = control.goodbye().reason();
      if (control.goodbye().final()) refusal_ = final_goodbye(control.goodbye().reason());
      finish("peer left: " + control.goodbye().reason());
      return {};
    case msg::Control::KIND_NOT_SET:
      return {};  // a control message of a later version; such additions may be ignored
  }
  return {};
}

Result<void> Connection::on_hello(const msg::Hello& peer) {
  if (phase_ != Phase::Greeting) return bad_peer("sends a second Hello message");
  if (const Result<void> agreed = agree_on_version(peer); !agreed) return agreed;
  if (peer.name().size() > kMaxNameBytes || peer.role().size() > kMaxNameBytes ||
      peer.token().size() > kMaxTokenBytes || peer.token_proof().size() > kMaxNameBytes ||
      peer.consent().size() > kMaxReasonBytes || peer.voice_consent().size() > kMaxReasonBytes)
    return bad_peer(
        "has a name, a role or a token's proof longer than 128 B, or a token or a consent longer than 512 B");
  phase_ = Phase::Open;
  parser_.set_max_payload_bytes(options_.max_payload_bytes);
  watch(kSilenceDeadline, "no message arrived for 5 s");
  owner_->on_ready(peer);
  wake();
  return {};
}

/// Each end names the oldest and the newest version that it speaks; the newest one in common is spoken from now on.
Result<void> Connection::agree_on_version(const msg::Hello& peer) {
  const std::uint32_t newest_of_peer = std::max(peer.protocol(), peer.newest_protocol());
  const std::uint32_t newest = std::min<std::uint32_t>(newest_of_peer, kProtocolVersion);
  if (newest < peer.protocol() || !is_spoken(newest)) {
    const Error error = bad_peer("it speaks version " + std::to_string(peer.protocol()) +
                                 " of the wire protocol instead of version " + spoken_versions());
    refusal_ = other_version(error.what);
    return error;
  }
  outgoing_.speak(static_cast<std::uint8_t>(newest));
  return {};
}

Result<void> Connection::on_subscription(const msg::Subscribe& subscribe) {
  if (subscribe.topics_size() > kMaxSubscriptions) return bad_peer("subscribes to more than 64 topics");
  for (const std::string& name : subscribe.topics())
    if (name.size() > kMaxNameBytes) return bad_peer("subscribes to a topic whose name is longer than 128 B");
  owner_->on_subscribe({subscribe.topics().begin(), subscribe.topics().end()});
  return {};
}

Result<void> Connection::on_datagram_offer(const msg::DatagramOffer& offer) {
  if (std::exchange(has_offer_, true)) return bad_peer("offers datagrams twice");
  owner_->on_datagram_offer(offer);
  return {};
}

Result<void> Connection::on_hand_over(const msg::HandOver& request) {
  if (request.to().size() > kMaxNameBytes || request.outcome().size() > kMaxReasonBytes)
    return bad_peer("sends a hand-over with a name longer than 128 B, or an outcome longer than 512 B");
  owner_->on_hand_over(request);
  return {};
}

Result<void> Connection::on_ice_path(const msg::IcePath& message) {
  if (message.ByteSizeLong() > kMaxIcePathBytes) return bad_peer("sends more than 8 KiB about a path for datagrams");
  owner_->on_ice_path(message);
  return {};
}

Result<void> Connection::on_data(Frame frame) {
  Result<std::optional<Message>> message = channels_.take(std::move(frame));
  if (!message) return message.error();
  if (*message) owner_->on_message(std::move(**message));
  return {};
}

void Connection::send(msg::Control control) {
  if (phase_ == Phase::Leaving || phase_ == Phase::Closed) return;
  if (!outgoing_.add(std::move(control))) return finish("the peer sends requests without reading the replies");
  write();
}

/// The next frame to write: a control message, else a message of the owner, else the Goodbye. False: there is none.
bool Connection::begin_frame() {
  if (outgoing_.begin_control()) return true;
  const bool sends_data = phase_ == Phase::Open || (phase_ == Phase::Leaving && farewell_.after_messages);
  if (std::optional<Message> message = sends_data ? owner_->next_to_send() : std::nullopt) {
    outgoing_.begin(std::move(*message));
    return true;
  }
  if (phase_ != Phase::Leaving) return false;
  farewell_.is_said = true;
  msg::Control goodbye;
  goodbye.mutable_goodbye()->set_reason(farewell_.reason.substr(0, kMaxReasonBytes));
  goodbye.mutable_goodbye()->set_final(farewell_.is_final);
  outgoing_.begin(std::move(goodbye));
  return true;
}

void Connection::write() {
  if (outgoing_.is_writing() || phase_ == Phase::Closed || farewell_.is_said || !begin_frame()) return;
  stream_->async_write(outgoing_.buffers(),
                       [self = shared_from_this()](const boost::system::error_code& code, std::size_t) {
                         self->outgoing_.end();
                         if (self->phase_ == Phase::Closed) return;
                         if (code) return self->on_lost(code);
                         if (self->farewell_.is_said) return self->stream_->end_writing();
                         self->write();
                       });
}

}  // namespace telepalp::wire
