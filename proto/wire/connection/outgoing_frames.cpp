#include "proto/wire/connection/outgoing_frames.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "proto/words/demand.h"

namespace telepalp::wire {
namespace {

constexpr std::size_t kMaxProbes = 64;  // unanswered probes: a probe each 20 ms with a delay of a second
constexpr std::uint64_t kLatestStamp = std::uint64_t{1} << 61;  // beyond it, sums of stamps could overflow

Nanoseconds local_now() noexcept { return std::chrono::steady_clock::now().time_since_epoch(); }

std::uint64_t stamp(Nanoseconds since_epoch) noexcept { return static_cast<std::uint64_t>(since_epoch.count()); }

/// The channel number of `topic`: its position, from 1, in the list of topics that this end publishes.
std::uint32_t channel_of(const std::vector<Topic>& publishes, const Topic& topic) {
  const auto found = std::ranges::find(publishes, topic.name, &Topic::name);
  demand(found != publishes.end(), "a program sends only topics that it advertises");
  return static_cast<std::uint32_t>(found - publishes.begin()) + 1;
}

}  // namespace

msg::Control OutgoingFrames::advertise() const {
  msg::Control control;
  control.mutable_advertise();
  for (const Topic& topic : publishes_) {
    msg::Advertise::Topic& entry = *control.mutable_advertise()->add_topics();
    entry.set_channel(channel_of(publishes_, topic));
    entry.set_name(std::string(topic.name));
    entry.set_schema(std::string(topic.schema));
  }
  return control;
}

bool OutgoingFrames::add(msg::Control control) {
  if (control_.size() >= kMaxWaiting) return false;
  control_.push_back(std::move(control));
  return true;
}

bool OutgoingFrames::begin_control() {
  if (control_.empty()) return false;
  msg::Control control = std::move(control_.front());
  control_.pop_front();
  begin(std::move(control));
  return true;
}

void OutgoingFrames::begin(msg::Control control) {
  // The probe is stamped when it is written, not when it is queued, because the wait behind an image is no network
  // delay.
  if (control.has_clock_probe()) {
    asked_.push_back(local_now());
    if (asked_.size() > kMaxProbes) asked_.pop_front();
    control.mutable_clock_probe()->set_asked_ns(stamp(asked_.back()));
  }
  if (control.has_clock_reply())
    control.mutable_clock_reply()->set_replied_ns(stamp(session_now_().time_since_epoch()));
  begin({.kind = FrameKind::Control, .sequence = ++control_sequence_, .version = version_},
        std::make_shared<const std::string>(control.SerializeAsString()));
}

void OutgoingFrames::begin(Message message) {
  begin({.kind = FrameKind::Data,
         .sequence = message.sequence,
         .published = message.published,
         .channel = channel_of(publishes_, message.topic),
         .version = version_,
         .predicted = !message.key_frame},
        std::move(message.payload));
}

void OutgoingFrames::begin(FrameHeader header, std::shared_ptr<const std::string> payload) {
  demand(payload->size() <= kMaxPayloadBytes, "a message is not larger than 8 MiB");
  header.payload_bytes = static_cast<std::uint32_t>(payload->size());
  header_ = encode_header(header);
  payload_ = std::move(payload);
}

std::vector<boost::asio::const_buffer> OutgoingFrames::buffers() const {
  return {boost::asio::buffer(header_), boost::asio::buffer(*payload_)};
}

std::optional<ClockSample> OutgoingFrames::sample(const msg::ClockReply& reply, Nanoseconds heard) {
  const auto question = std::ranges::find(asked_, reply.asked_ns(), stamp);
  if (question == asked_.end()) return std::nullopt;  // no reply to a probe of this connection
  const Nanoseconds asked = *question;
  asked_.erase(asked_.begin(), question + 1);  // replies come in order
  if (reply.received_ns() > kLatestStamp || reply.replied_ns() > kLatestStamp) return std::nullopt;
  return ClockSample{.asked = asked,
                     .received = Nanoseconds{static_cast<std::int64_t>(reply.received_ns())},
                     .replied = Nanoseconds{static_cast<std::int64_t>(reply.replied_ns())},
                     .heard = heard};
}

}  // namespace telepalp::wire
