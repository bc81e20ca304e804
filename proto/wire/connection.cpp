#include "proto/wire/connection.h"

#include <algorithm>
#include <utility>

#include "codec/unmarked/unmarked_depth.h"
#include "proto/words/demand.h"
#include "proto/words/error_line.h"

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMaxHelloBytes = 4096;
constexpr std::size_t kMaxWaitingControl = 64;
constexpr std::size_t kMaxProbes = 64;  // unanswered probes: a probe each 20 ms with a delay of a second
constexpr std::size_t kMaxChannels = 256;
constexpr int kMaxSubscriptions = 64;
constexpr std::size_t kMaxNameBytes = 128;
constexpr std::size_t kMaxTokenBytes = 512;
constexpr std::size_t kMaxReasonBytes = 512;
constexpr auto kLinger = 500ms;
constexpr std::uint64_t kLatestStamp = std::uint64_t{1} << 61;  // beyond it, sums of stamps could overflow

/// on_bytes() puts the peer's address before it.
Error bad_peer(std::string what) {
  return {.what = std::move(what),
          .where = {},
          .fix = "install the same version of telepalp at both ends; other programs must follow proto/WIRE.md"};
}

Error no_publisher(const Topic& topic) {
  return {.what = "this client may not publish " + std::string(topic.name),
          .where = {},
          .fix = "publish only topics that begin with /station/, from a station that holds the touch"};
}

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

Nanoseconds local_now() noexcept { return std::chrono::steady_clock::now().time_since_epoch(); }

std::uint64_t stamp(Nanoseconds since_epoch) noexcept { return static_cast<std::uint64_t>(since_epoch.count()); }

/// The channel number of `topic`: its position, from 1, in the list of topics that this end publishes.
std::uint32_t channel_of(const std::vector<Topic>& publishes, const Topic& topic) {
  const auto found =
      std::find_if(publishes.begin(), publishes.end(), [&](const Topic& t) { return t.name == topic.name; });
  demand(found != publishes.end(), "a program sends only topics that it advertises");
  return static_cast<std::uint32_t>(found - publishes.begin()) + 1;
}

msg::Control hello(const Connection::Options& options) {
  msg::Control control;
  control.mutable_hello()->set_protocol(kOldestProtocolVersion);
  control.mutable_hello()->set_newest_protocol(kProtocolVersion);
  control.mutable_hello()->set_name(options.name);
  control.mutable_hello()->set_role(options.role);
  control.mutable_hello()->set_run(options.run);
  control.mutable_hello()->set_token(options.token);
  control.mutable_hello()->set_datagrams(options.datagrams);
  control.mutable_hello()->set_accepts_touch(options.accepts_touch);
  return control;
}

/// A frame of a version that does not mark predicted messages is decided by its payload.
bool is_key_frame(const Topic& topic, const Frame& frame) {
  if (!topic.predicted) return true;
  if (frame.header.version >= kFirstVersionThatMarks) return !frame.header.predicted;
  return codec::is_unmarked_key_frame(frame.payload);
}

msg::Control advertise(const std::vector<Topic>& publishes) {
  msg::Control control;
  control.mutable_advertise();
  for (const Topic& topic : publishes) {
    msg::Advertise::Topic& entry = *control.mutable_advertise()->add_topics();
    entry.set_channel(channel_of(publishes, topic));
    entry.set_name(std::string(topic.name));
    entry.set_schema(std::string(topic.schema));
  }
  return control;
}

}  // namespace

Connection::Connection(std::unique_ptr<ByteStream> stream, Options options, ConnectionOwner& owner)
    : stream_(std::move(stream)),
      options_(std::move(options)),
      owner_(&owner),
      deadline_(stream_->executor()),
      read_again_(stream_->executor()),
      parser_(kMaxHelloBytes) {}

void Connection::start() {
  send(hello(options_));
  send(advertise(options_.publishes));
  watch(kHandshakeDeadline, "no Hello message (the greeting of a telepalp program) arrived within 5 s");
  read();
}

void Connection::wake() { write(); }

void Connection::subscribe(const std::vector<std::string>& topics) {
  msg::Control control;
  control.mutable_subscribe();  // the field must be present even with an empty list
  for (const std::string& topic : topics) control.mutable_subscribe()->add_topics(topic);
  for (auto& [number, channel] : channels_)
    channel.last_sequence = 0;  // messages from before the subscription do not count as missed
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

void Connection::hand_over(const msg::HandOver& request) {
  msg::Control control;
  *control.mutable_hand_over() = request;
  send(std::move(control));
}

void Connection::take_datagram(Message message) {
  const auto found = std::find_if(channels_.begin(), channels_.end(), [&](const auto& entry) {
    return entry.second.topic && entry.second.topic->name == message.topic.name;
  });
  if (phase_ != Phase::Open || found == channels_.end()) return;
  found->second.by_datagram = true;
  deliver(found->second, std::move(message));
}

void Connection::close(const std::string& reason, bool final) {
  refuses_ = final;
  drains_ = phase_ == Phase::Open;
  leave(reason);
}

void Connection::leave(const std::string& reason) {
  if (phase_ == Phase::Leaving || phase_ == Phase::Closed) return;
  phase_ = Phase::Leaving;
  leaving_because_ = reason;
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
  finish(phase_ == Phase::Leaving ? leaving_because_ : "the connection ended unexpectedly: " + code.message());
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

/// Each read delays the next one in proportion to its bytes. A peer that was silent may first send as much as in two
/// seconds.
void Connection::read_when_due(std::size_t bytes_before) {
  if (options_.max_read_bytes_per_s == 0) return read();
  constexpr auto kBurst = 2s;
  const auto now = std::chrono::steady_clock::now();
  const double cost_s = static_cast<double>(bytes_before) / static_cast<double>(options_.max_read_bytes_per_s);
  read_due_ = std::max(read_due_, now - kBurst) +
              std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(cost_s));
  if (read_due_ <= now) return read();
  read_again_.expires_at(read_due_);
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
      return on_advertise(control.advertise());
    case msg::Control::kSubscribe:
      return on_subscription(control.subscribe());
    case msg::Control::kClockProbe: {
      msg::Control answer;
      answer.mutable_clock_reply()->set_asked_ns(control.clock_probe().asked_ns());
      answer.mutable_clock_reply()->set_received_ns(stamp(owner_->session_now().time_since_epoch()));
      send(std::move(answer));
      return {};
    }
    case msg::Control::kClockReply:
      on_clock_reply(control.clock_reply());
      return {};
    case msg::Control::kKeyFrameRequest:
      if (const std::optional<Topic> topic = find_topic(control.key_frame_request().topic()))
        owner_->on_key_frame_request(*topic, session_time(control.key_frame_request().published_ns()));
      return {};
    case msg::Control::kDatagramOffer:
      return on_datagram_offer(control.datagram_offer());
    case msg::Control::kHandOver:
      return on_hand_over(control.hand_over());
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
  if (peer.name().size() > kMaxNameBytes || peer.role().size() > kMaxNameBytes || peer.token().size() > kMaxTokenBytes)
    return bad_peer("has a name or a role longer than 128 B, or a token longer than 512 B");
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
  version_ = static_cast<std::uint8_t>(newest);
  return {};
}

Result<void> Connection::on_advertise(const msg::Advertise& advertise) {
  for (const msg::Advertise::Topic& entry : advertise.topics()) {
    const std::optional<Topic> topic = find_topic(entry.name());
    if (topic && topic->schema != entry.schema())
      return bad_peer("advertises " + std::string(topic->name) + " with another message type than " +
                      std::string(topic->schema));
    if (topic && !owner_->accepts(*topic)) return no_publisher(*topic);
    if (channels_.size() >= kMaxChannels) return bad_peer("advertises more than 256 channels");
    if (entry.channel() == 0) return bad_peer("announces a topic on channel 0, which is reserved for control messages");
    if (!channels_.try_emplace(entry.channel(), Incoming{topic, 0}).second)
      return bad_peer("advertises channel " + std::to_string(entry.channel()) + " twice");
  }
  return {};
}

Result<void> Connection::on_subscription(const msg::Subscribe& subscribe) {
  if (subscribe.topics_size() > kMaxSubscriptions) return bad_peer("subscribes to more than 64 topics");
  for (const std::string& name : subscribe.topics())
    if (name.size() > kMaxNameBytes) return bad_peer("subscribes to a topic whose name is longer than 128 B");
  owner_->on_subscribe({subscribe.topics().begin(), subscribe.topics().end()});
  return {};
}

void Connection::on_clock_reply(const msg::ClockReply& reply) {
  const Nanoseconds heard = local_now();
  const auto question =
      std::find_if(asked_.begin(), asked_.end(), [&](Nanoseconds asked) { return stamp(asked) == reply.asked_ns(); });
  if (question == asked_.end()) return;  // no reply to a probe of this connection
  const Nanoseconds asked = *question;
  asked_.erase(asked_.begin(), question + 1);  // replies come in order
  if (reply.received_ns() > kLatestStamp || reply.replied_ns() > kLatestStamp) return;
  owner_->on_clock({.asked = asked,
                    .received = Nanoseconds{static_cast<std::int64_t>(reply.received_ns())},
                    .replied = Nanoseconds{static_cast<std::int64_t>(reply.replied_ns())},
                    .heard = heard});
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

Result<void> Connection::on_data(Frame frame) {
  const auto found = channels_.find(frame.header.channel);
  if (found == channels_.end())
    return bad_peer("sends on channel " + std::to_string(frame.header.channel) + " without advertising it");
  Incoming& channel = found->second;
  if (!channel.topic) return {};
  if (frame.header.predicted && !channel.topic->predicted)
    return bad_peer("sends a predicted message of " + std::string(channel.topic->name) +
                    ", a topic without predicted messages");
  const bool key_frame = is_key_frame(*channel.topic, frame);
  deliver(channel, {*channel.topic, frame.header.published,
                    std::make_shared<const std::string>(std::move(frame.payload)), frame.header.sequence, key_frame});
  return {};
}

void Connection::deliver(Incoming& channel, Message message) {
  const std::uint64_t sequence = message.sequence;
  if (channel.by_datagram && sequence <= channel.last_sequence)
    return;  // it was counted as missed when it was overtaken
  ReceivedCount& count = received_[channel.topic->name];
  ++count.messages;
  if (channel.last_sequence != 0 && sequence > channel.last_sequence)
    count.missed += sequence - channel.last_sequence - 1;
  channel.last_sequence = sequence;
  owner_->on_message(std::move(message));
}

void Connection::send(msg::Control control) {
  if (phase_ == Phase::Leaving || phase_ == Phase::Closed) return;
  if (control_.size() >= kMaxWaitingControl) return finish("the peer sends requests without reading the replies");
  control_.push_back(std::move(control));
  write();
}

void Connection::write() {
  if (writing_ || phase_ == Phase::Closed || said_goodbye_) return;
  if (!control_.empty()) {
    msg::Control control = std::move(control_.front());
    control_.pop_front();
    return write_control(std::move(control));
  }
  const bool sends_data = phase_ == Phase::Open || (phase_ == Phase::Leaving && drains_);
  if (std::optional<Message> message = sends_data ? owner_->next_to_send() : std::nullopt)
    return write_frame({.kind = FrameKind::Data,
                        .sequence = message->sequence,
                        .published = message->published,
                        .channel = channel_of(options_.publishes, message->topic),
                        .version = version_,
                        .predicted = !message->key_frame},
                       std::move(message->payload));
  if (phase_ != Phase::Leaving) return;
  said_goodbye_ = true;
  msg::Control goodbye;
  goodbye.mutable_goodbye()->set_reason(leaving_because_.substr(0, kMaxReasonBytes));
  goodbye.mutable_goodbye()->set_final(refuses_);
  write_control(std::move(goodbye));
}

void Connection::write_control(msg::Control control) {
  // The probe is stamped when it is written, not when it is queued, because the wait behind an image is no network
  // delay.
  if (control.has_clock_probe()) {
    asked_.push_back(local_now());
    if (asked_.size() > kMaxProbes) asked_.pop_front();
    control.mutable_clock_probe()->set_asked_ns(stamp(asked_.back()));
  }
  if (control.has_clock_reply())
    control.mutable_clock_reply()->set_replied_ns(stamp(owner_->session_now().time_since_epoch()));
  write_frame({.kind = FrameKind::Control, .sequence = ++control_sequence_, .version = version_},
              std::make_shared<const std::string>(control.SerializeAsString()));
}

void Connection::write_frame(FrameHeader header, std::shared_ptr<const std::string> payload) {
  demand(payload->size() <= kMaxPayloadBytes, "a message is not larger than 8 MiB");
  header.payload_bytes = static_cast<std::uint32_t>(payload->size());
  header_being_written_ = encode_header(header);
  payload_being_written_ = std::move(payload);
  writing_ = true;
  stream_->async_write({boost::asio::buffer(header_being_written_), boost::asio::buffer(*payload_being_written_)},
                       [self = shared_from_this()](const boost::system::error_code& code, std::size_t) {
                         self->writing_ = false;
                         self->payload_being_written_.reset();
                         if (self->phase_ == Phase::Closed) return;
                         if (code) return self->on_lost(code);
                         if (self->said_goodbye_) return self->stream_->end_writing();
                         self->write();
                       });
}

}  // namespace telepalp::wire
