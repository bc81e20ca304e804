#include "server/gateway/voice/viewer_voice.h"

#include "proto/wire/voice/voice_message.h"

namespace telepalp::gateway {

keys::Operation operation_to_speak(const wire::Topic& topic) noexcept {
  return topic.name == wire::kDoctorVoice.name ? keys::Operation::SpeakAsDoctor : keys::Operation::SpeakAtPatient;
}

std::optional<wire::Message> ViewerVoice::hear(const wire::Topic& topic, const std::string& payload,
                                               std::uint64_t viewer, SessionTime now) {
  constexpr std::chrono::seconds kFurthest{10};
  if (!rate_.has(1.0, now.time_since_epoch())) return std::nullopt;
  rate_.spend(1.0);
  std::optional<msg::VoiceFrame> frame = wire::read_voice_frame(payload);
  if (!frame) return std::nullopt;
  frame->set_talker(viewer);
  const std::uint64_t at = frame->captured_ns();
  const auto now_ns = static_cast<std::uint64_t>(to_nanoseconds(now));
  const std::uint64_t apart = at > now_ns ? at - now_ns : now_ns - at;
  if (apart > static_cast<std::uint64_t>(Nanoseconds(kFurthest).count())) frame->set_captured_ns(now_ns);
  said_ = {};
  return wire::make_message(topic, now, *frame);
}

void ViewerVoice::refuse(std::string_view why, const std::function<void(const std::string&)>& say) {
  if (said_ == why) return;
  said_ = why;
  say(std::string(why));
}

}  // namespace telepalp::gateway
