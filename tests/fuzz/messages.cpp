// What a peer sends in valid frames: messages of each topic, as a station or a viewer publishes them, and control
// messages. The first byte of the input chooses the topic.
#include <cmath>
#include <cstdint>
#include <string>

#include "messages/control.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/topics.h"
#include "proto/wire/viewer/viewer_hand.h"
#include "proto/wire/voice/voice_message.h"
#include "proto/words/demand.h"
#include "server/hub/upstream.h"

namespace {

using namespace telepalp;

/// A message that the hub takes from a station stays readable after the hub has written the sender's number into it.
void publish(const wire::Topic& topic, const std::string& payload) {
  const wire::Message message{topic, {}, std::make_shared<const std::string>(payload), 0, true};
  if (!hub::is_valid_upstream(message)) return;
  demand(hub::may_publish_upstream(topic), "only topics of a station are taken");
  const wire::Message sent = hub::with_sender(message, 7);
  demand(hub::is_valid_upstream(sent), "the sender's number keeps a message readable");
  msg::Sender sender;
  demand(sender.ParseFromString(*sent.payload) && sender.sender() == 7, "a peer cannot choose its number");
}

/// A viewer's hand that is accepted is finite and at most 10 m from the camera along each axis.
void move_hand(const std::string& payload) {
  const auto hand = wire::read_viewer_hand(payload);
  if (!hand) return;
  for (const double at_m : {hand->hand_camera().x(), hand->hand_camera().y(), hand->hand_camera().z()})
    demand(std::isfinite(at_m) && std::abs(at_m) <= 10.0, "a hand is within 10 m");
}

/// Words that are accepted are bounded, and stay acceptable after the server has written the talker's number.
void speak(const std::string& payload) {
  auto frame = wire::read_voice_frame(payload);
  if (!frame) return;
  demand(frame->begun() <= frame->number() && frame->earlier_size() <= wire::kMaxEarlierVoicePackets,
         "no packet is of a time before the microphone was opened");
  frame->set_talker(7);
  const auto again = wire::read_voice_frame(frame->SerializeAsString());
  demand(!again || again->talker() == 7, "a viewer cannot choose its number");
}

/// A control message keeps its kind when it is parsed, serialised and parsed again.
void control(const std::string& payload) {
  msg::Control read;
  if (!read.ParseFromString(payload)) return;
  msg::Control again;
  demand(again.ParseFromString(read.SerializeAsString()) && again.kind_case() == read.kind_case(),
         "a control message survives being written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string payload(reinterpret_cast<const char*>(data + 1), size - 1);
  if (data[0] < wire::kTopics.size()) publish(wire::kTopics[data[0]], payload);
  if (data[0] == 100) move_hand(payload);
  if (data[0] == 101) control(payload);
  if (data[0] == 102) speak(payload);
  return 0;
}
