#include "server/playback/impaired_path.h"

#include <algorithm>
#include <utility>

namespace telepalp::playback {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kSegment_B = 1448;  // of a TCP connection over Ethernet
constexpr std::size_t kMostImages = 60;   // limit of the depth images that wait; a group of pictures has 12 by default
constexpr Nanoseconds kRoomAgain = 5ms;   // wait before the bottleneck's full queue is checked again

}  // namespace

ImpairedPath::ImpairedPath(SessionTime now, const impaired::Profile& network, std::uint64_t seed)
    : begin_(now), down_(network.down, seed), up_(network.up, seed + 1) {
  begin_link_session();
}

/// Both ends are in this process, so the key need not be secret. The session's number lets each end refuse datagrams of
/// the session before.
void ImpairedPath::begin_link_session() {
  const link::DatagramLinkSettings settings{
      .seal = {.session = {}, .number = ++link_session_, .cipher = link::preferred_cipher()}};
  server_.emplace(settings, link::End::Server);
  client_.emplace(settings, link::End::Client);
}

void ImpairedPath::change(SessionTime now, const impaired::Profile& network) {
  down_.change(since_begin(now), network.down);
  up_.change(since_begin(now), network.up);
  begin_link_session();
}

void ImpairedPath::send(SessionTime now, wire::Message message) {
  if (message.topic.has_deadline()) {
    wait_for_link(std::move(message));
  } else if (stream_B_ + message.payload->size() <= kMostWaiting_B) {
    const std::size_t bytes = std::max<std::size_t>(message.payload->size(), 1);
    stream_B_ += bytes;
    stream_.push_back({.message = std::move(message), .unsent_B = bytes, .missing_B = bytes});
  }
  transmit(now);
}

/// The newest key frame of a topic waits with those predicted from it, because each needs the one before it.
void ImpairedPath::wait_for_link(wire::Message message) {
  Waiting& waiting = waiting_[*message.topic.datagram_channel];
  if (message.key_frame || waiting.size() >= kMostImages) waiting.clear();
  waiting.push_back(std::move(message));
}

/// True if a message was handed to the link. A pose is small and goes before an image.
bool ImpairedPath::offer_next(SessionTime now) {
  if (!server_->ready_for_frame(now)) return false;
  for (auto waiting = waiting_.rbegin(); waiting != waiting_.rend(); ++waiting) {
    Waiting& messages = waiting->second;
    if (messages.empty()) continue;
    (void)server_->offer(wire::frame_of(messages.front(), now));
    messages.pop_front();
    return true;
  }
  return false;
}

void ImpairedPath::transmit(SessionTime now) {
  const auto send = [&](const link::Datagram& datagram, impaired::ImpairedLink& to) {
    const auto bytes = datagram.bytes();
    to.send(since_begin(now), {.bytes = {bytes.begin(), bytes.end()}});
  };
  do {
    while (const auto datagram = server_->next(now)) send(*datagram, down_);
  } while (offer_next(now));
  while (const auto datagram = client_->next(now)) send(*datagram, up_);
  send_segments(now);
}

void ImpairedPath::send_segments(SessionTime now) {
  for (Segmented& outgoing : stream_) {
    while (outgoing.unsent_B > 0) {
      const std::size_t bytes = std::min(outgoing.unsent_B, kSegment_B);
      if (!down_.has_room(since_begin(now), bytes)) return;
      down_.send(since_begin(now), {.bytes = std::vector<std::byte>(bytes), .stream = true});
      outgoing.unsent_B -= bytes;
    }
  }
}

std::vector<wire::Message> ImpairedPath::receive(SessionTime now) {
  std::vector<wire::Message> arrived;
  while (const auto packet = up_.receive(since_begin(now))) (void)server_->received(packet->bytes, now);
  deliver(now, arrived);
  transmit(now);
  return arrived;
}

void ImpairedPath::deliver(SessionTime now, std::vector<wire::Message>& arrived) {
  while (const auto packet = down_.receive(since_begin(now))) {
    if (packet->stream)
      deliver_segment(packet->bytes.size(), arrived);
    else
      (void)client_->received(packet->bytes, now);
  }
  while (const std::optional<link::Frame> frame = client_->take(now)) {
    std::optional<wire::Message> message = wire::message_of(*frame);
    if (message && frame->newest) arrived.push_back(std::move(*message));
    if (!frame->newest && frame->channel == wire::kCameraDepth.datagram_channel) ++late_images_;
  }
}

/// Segments arrive in the order in which they were sent, so each belongs to the first message that lacks bytes.
void ImpairedPath::deliver_segment(std::size_t bytes, std::vector<wire::Message>& arrived) {
  Segmented& first = stream_.front();
  first.missing_B -= bytes;
  if (first.missing_B > 0) return;
  stream_B_ -= std::max<std::size_t>(first.message.payload->size(), 1);
  arrived.push_back(std::move(first.message));
  stream_.pop_front();
}

std::vector<wire::Message> ImpairedPath::end() {
  std::vector<wire::Message> rest;
  for (Segmented& one : stream_) rest.push_back(std::move(one.message));
  stream_.clear();
  return rest;
}

std::optional<SessionTime> ImpairedPath::due(SessionTime now) const {
  std::optional<SessionTime> earliest;
  const auto consider = [&](std::optional<SessionTime> at) {
    if (at && (!earliest || *at < *earliest)) earliest = at;
  };
  const auto arrival = [&](const impaired::ImpairedLink& link) -> std::optional<SessionTime> {
    const std::optional<Nanoseconds> next = link.next_arrival();
    return next ? std::optional(begin_ + *next) : std::nullopt;
  };
  consider(arrival(down_));
  consider(arrival(up_));
  consider(server_->due(now));
  consider(client_->due(now));
  const bool waits = (!stream_.empty() && stream_.back().unsent_B > 0) ||
                     std::any_of(waiting_.begin(), waiting_.end(), [](const auto& one) { return !one.second.empty(); });
  if (waits) consider(now + kRoomAgain);
  return earliest;
}

}  // namespace telepalp::playback
