#include "server/playback/session_network.h"

#include <algorithm>
#include <utility>

namespace telepalp::playback {
namespace {

constexpr std::uint64_t kSeed = 1;
/// The timer's least sleep: packets that arrive within it are handled together.
constexpr Nanoseconds kLeastSleep = std::chrono::microseconds(200);

}  // namespace

SessionNetwork::SessionNetwork(boost::asio::io_context& io, wire::SessionClock clock,
                               std::function<void(wire::Message)> publish)
    : clock_(clock), publish_(std::move(publish)), timer_(io) {}

void SessionNetwork::send(wire::Message message) {
  if (message.topic.has_deadline()) message.sequence = ++passing_[message.topic.name].taken;
  if (!path_) return arrive(std::move(message));
  path_->send(clock_.now(), std::move(message));
  pump();
}

Result<void> SessionNetwork::apply(const std::string& json) {
  const Result<msg::NetworkCommand> command = read_network_command(json);
  if (!command) return command.error();
  Result<ChosenNetwork> chosen = after_command(chosen_, *command);
  if (!chosen) return chosen.error();
  chosen_ = std::move(*chosen);
  if (!chosen_.impairs() && path_) {
    for (wire::Message& message : path_->end()) arrive(std::move(message));
    path_.reset();
  } else if (chosen_.impairs() && path_) {
    path_->change(clock_.now(), chosen_.network);
  } else if (chosen_.impairs()) {
    path_.emplace(clock_.now(), chosen_.network, kSeed);
  }
  begin_counts();
  return {};
}

void SessionNetwork::begin_counts() {
  packets_before_ = path_ ? path_->statistics() : impaired::LinkStatistics{};
  late_before_ = path_ ? path_->late_images() : 0;
  images_before_ = passing_[wire::kCameraDepth.name].taken;
  images_arrived_ = 0;
}

msg::NetworkState SessionNetwork::state() const {
  msg::NetworkState state = state_of(chosen_);
  const impaired::LinkStatistics packets = path_ ? path_->statistics() : impaired::LinkStatistics{};
  state.set_packets_sent(packets.sent - packets_before_.sent);
  state.set_packets_delivered(packets.delivered - packets_before_.delivered);
  state.set_packets_lost(packets.lost + packets.dropped - packets_before_.lost - packets_before_.dropped);
  const std::uint64_t late = (path_ ? path_->late_images() : 0) - late_before_;
  const auto images = passing_.find(wire::kCameraDepth.name);
  const std::uint64_t last_image = images == passing_.end() ? 0 : images->second.published;
  const std::uint64_t decided = last_image - std::min(last_image, images_before_);
  state.set_images_arrived(images_arrived_);
  state.set_images_late(late);
  state.set_images_lost(decided - std::min(decided, images_arrived_ + late));
  state.set_image_delay_ms(to_milliseconds(image_delay_));
  return state;
}

void SessionNetwork::pump() {
  if (stopped_ || !path_) return;
  for (wire::Message& message : path_->receive(clock_.now())) arrive(std::move(message));
  wake_when_due();
}

void SessionNetwork::wake_when_due() {
  const SessionTime now = clock_.now();
  const std::optional<SessionTime> due = path_->due(now);
  if (!due) return;
  timer_.expires_after(std::max(*due - now, kLeastSleep));
  timer_.async_wait([this](const boost::system::error_code& cancelled) {
    if (!cancelled) pump();
  });
}

/// False: the message is predicted from one that did not arrive. The path itself checks this; a message on the way when
/// the path began or ended is checked here.
bool SessionNetwork::is_decodable(const wire::Message& message) {
  std::uint64_t& last = passing_[message.topic.name].published;
  if (!message.key_frame && message.sequence != last + 1) return false;
  last = message.sequence;
  return true;
}

void SessionNetwork::arrive(wire::Message message) {
  if (message.topic.predicted && !is_decodable(message)) return;
  if (message.topic.name == wire::kCameraDepth.name) {
    if (message.sequence > images_before_) ++images_arrived_;
    image_delay_ = std::max(clock_.now() - message.published, Nanoseconds{0});
  }
  // A stamp from before the network would make the next link drop the message as too late.
  if (path_) message.published = clock_.now();
  publish_(std::move(message));
}

void SessionNetwork::stop() {
  stopped_ = true;
  timer_.cancel();
}

}  // namespace telepalp::playback
