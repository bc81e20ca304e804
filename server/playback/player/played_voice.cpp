#include "server/playback/player/played_voice.h"

#include <algorithm>

#include "proto/wire/voice/voice_message.h"

namespace telepalp::playback {
namespace {

constexpr unsigned kNumberBits = 32;  // of a viewer's number, which the jumps stand above

}  // namespace

void PlayedVoice::jumped() noexcept {
  ++jumps_;
  begun_.clear();
}

std::optional<wire::Message> PlayedVoice::as_played(const wire::Message& retimed) {
  std::optional<msg::VoiceFrame> frame = wire::read_voice_frame(*retimed.payload);
  if (!frame) return std::nullopt;
  const auto [known, is_new] = begun_.try_emplace(retimed.topic.name);
  Begun& begun = known->second;
  if (is_new || begun.talker != frame->talker()) begun = {.talker = frame->talker(), .number = frame->number()};
  if (frame->number() < begun.number) return std::nullopt;
  frame->set_begun(std::max(frame->begun(), begun.number));
  const auto most_earlier = static_cast<int>(std::min<std::uint32_t>(frame->number() - frame->begun(), 1000));
  if (frame->earlier_size() > most_earlier)
    frame->mutable_earlier()->DeleteSubrange(most_earlier, frame->earlier_size() - most_earlier);
  frame->set_talker((frame->talker() & ((std::uint64_t{1} << kNumberBits) - 1)) | jumps_ << kNumberBits);
  return wire::make_message(retimed.topic, retimed.published, *frame);
}

}  // namespace telepalp::playback
