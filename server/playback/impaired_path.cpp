#include "server/playback/impaired_path.h"

#include <algorithm>
#include <utility>

namespace telepalp::playback {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kSegment_B = 1448;  // of a TCP connection over Ethernet
constexpr std::size_t kMostImages = 60;   // limit of the depth images that wait; a group of pictures has 12 by default
constexpr Nanoseconds kRoomAgain = 5ms;   // wait before the bottleneck's full queue is checked again

/// Both ends are in this process, so the key need not be secret. The session's number lets each end refuse datagrams of
/// the session before.
link::DatagramLinkSettings session_of(std::uint32_t number) {
  return {.seal = {.session = {}, .number = number, .cipher = link::preferred_cipher()}};
}

}  // namespace

ImpairedPath::ImpairedPath(SessionTime now, const impaired::Profile& network, std::uint64_t seed)
    : network_(now, network, seed, session_of(++link_session_)) {}

void ImpairedPath::change(SessionTime now, const impaired::Profile& network) {
  network_.change(now, network);
  network_.begin_link_session(session_of(++link_session_));
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
  if (!network_.server().ready_for_frame(now)) return false;
  for (auto waiting = waiting_.rbegin(); waiting != waiting_.rend(); ++waiting) {
    Waiting& messages = waiting->second;
    if (messages.empty()) continue;
    (void)network_.server().offer(wire::frame_of(messages.front(), now));
    messages.pop_front();
    return true;
  }
  return false;
}

void ImpairedPath::transmit(SessionTime now) {
  do network_.transmit_from_server(now);
  while (offer_next(now));
  network_.transmit_from_client(now);
  send_segments(now);
}

void ImpairedPath::send_segments(SessionTime now) {
  for (Segmented& outgoing : stream_) {
    while (outgoing.unsent_B > 0) {
      const std::size_t bytes = std::min(outgoing.unsent_B, kSegment_B);
      if (!network_.down().has_room(network_.since_begin(now), bytes)) return;
      network_.down().send(network_.since_begin(now), {.bytes = std::vector<std::byte>(bytes), .stream = true});
      outgoing.unsent_B -= bytes;
    }
  }
}

std::vector<wire::Message> ImpairedPath::receive(SessionTime now) {
  std::vector<wire::Message> arrived;
  network_.deliver(now, [&](std::size_t bytes) { deliver_segment(bytes, arrived); });
  deliver_frames(now, arrived);
  transmit(now);
  return arrived;
}

void ImpairedPath::deliver_frames(SessionTime now, std::vector<wire::Message>& arrived) {
  while (const std::optional<link::Frame> frame = network_.client().take(now)) {
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
  const std::optional<SessionTime> due = network_.due(now);
  const bool waits = (!stream_.empty() && stream_.back().unsent_B > 0) ||
                     std::any_of(waiting_.begin(), waiting_.end(), [](const auto& one) { return !one.second.empty(); });
  return waits ? std::min(due.value_or(now + kRoomAgain), now + kRoomAgain) : due;
}

}  // namespace telepalp::playback
