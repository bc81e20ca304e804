#include "server/gateway/viewer_commands.h"

#include "proto/wire/viewer/viewer_hand.h"

namespace telepalp::gateway {
namespace {

constexpr std::size_t kMaxChannels = 8;
constexpr std::chrono::milliseconds kShortestPeriod{2};

Error command_refused(std::string what) {
  return {.what = std::move(what),
          .where = "client's message",
          .fix = "publish telepalp.msg.ViewerHand on /viewer/hand, as protobuf"};
}

}  // namespace

Result<void> ViewerCommands::advertise(const foxglove::Request::Channel& channel) {
  const std::optional<wire::Topic> topic = wire::find_topic(channel.topic);
  if (!topic || !(topic->spoken || topic->name == wire::kViewerHand.name))
    return command_refused("viewers may not publish '" + channel.topic.substr(0, 64) + "'");
  if (channel.encoding != "protobuf")
    return command_refused("encoding '" + channel.encoding.substr(0, 64) + "' is not supported");
  if (channels_.size() >= kMaxChannels && !channels_.contains(channel.id))
    return Error{.what = "this viewer has advertised " + std::to_string(kMaxChannels) +
                         " channels already, as many as it may have",
                 .where = "client's message",
                 .fix = "publish on the channel that was advertised first"};
  channels_.insert_or_assign(channel.id, *topic);
  return {};
}

bool ViewerCommands::is_hands(std::uint32_t channel) const {
  const auto found = channels_.find(channel);
  return found != channels_.end() && !found->second.spoken;
}

std::optional<ViewerCommands::Spoken> ViewerCommands::spoken(std::string_view bytes) const {
  std::optional<foxglove::ClientData> data = foxglove::read_client_data(bytes);
  const auto found = data ? channels_.find(data->channel) : channels_.end();
  if (found == channels_.end() || !found->second.spoken) return std::nullopt;
  return Spoken{found->second, std::move(data->payload)};
}

std::optional<msg::ViewerHand> ViewerCommands::read(std::string_view bytes) const {
  const std::optional<foxglove::ClientData> data = foxglove::read_client_data(bytes);
  msg::ViewerHand hand;
  if (!data || !is_hands(data->channel) || data->payload.size() > wire::kMaxViewerHandBytes ||
      !hand.ParseFromString(data->payload))
    return std::nullopt;
  return hand;
}

bool ViewerCommands::lets_go(std::string_view bytes) const {
  const std::optional<msg::ViewerHand> hand = read(bytes);
  return hand && hand->let_go();
}

std::optional<std::uint64_t> ViewerCommands::hands_over_to(std::string_view bytes) const {
  const std::optional<msg::ViewerHand> hand = read(bytes);
  if (!hand || hand->hand_over_to() == 0) return std::nullopt;
  return hand->hand_over_to();
}

bool ViewerCommands::asks_to_rearm(std::string_view bytes) const {
  const std::optional<msg::ViewerHand> hand = read(bytes);
  return hand && hand->rearm();
}

bool ViewerCommands::accepts_object(std::string_view bytes) const {
  const std::optional<msg::ViewerHand> hand = read(bytes);
  return hand && hand->accept_object();
}

Result<std::optional<wire::Message>> ViewerCommands::hear(std::string_view bytes, std::uint64_t viewer,
                                                          SessionTime now) {
  const std::optional<foxglove::ClientData> data = foxglove::read_client_data(bytes);
  if (!data) return command_refused("the binary message is not of the Foxglove protocol");
  if (!is_hands(data->channel))
    return command_refused("channel " + std::to_string(data->channel) + " was not advertised");
  std::optional<msg::ViewerHand> hand = wire::read_viewer_hand(data->payload);
  if (!hand || !hand->has_hand_camera())
    return command_refused("the message is not a ViewerHand, or its hand is more than 10 m from the camera");
  hand->set_rearm(false);  // only a message of its own re-arms, or accepts an object
  hand->set_accept_object(false);
  if (last_ && now >= *last_ && now - *last_ < kShortestPeriod) return std::optional<wire::Message>();
  last_ = now;
  hand->set_viewer(viewer);
  return std::optional(wire::make_message(wire::kViewerHand, now, *hand));
}

}  // namespace telepalp::gateway
