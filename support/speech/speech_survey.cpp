#include "support/speech/speech_survey.h"

#include <cstdlib>
#include <limits>

#include "proto/wire/voice/voice_message.h"
#include "support/speech/voice_packets.h"

namespace telepalp::speech {
namespace {

constexpr std::int64_t kMostOn = 3000;  // frames, a minute; further on, the talker's numbers have begun again
constexpr std::int64_t kMostBack = 50;  // frames
constexpr Nanoseconds kFurthest = std::chrono::seconds(15);  // of a microphone's time from that of publication

/// When the first sample of `frame` was spoken. A time that cannot be is replaced by that of publication.
SessionTime spoken_at(const msg::VoiceFrame& frame, SessionTime published) {
  const SessionTime replaced = published - kVoiceFrameTime;
  if (frame.captured_ns() > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return replaced;
  const SessionTime stated = session_time(static_cast<std::int64_t>(frame.captured_ns()));
  const bool is_near = stated > published - kFurthest && stated < published + kFurthest;
  return is_near ? stated : replaced;
}

}  // namespace

/// One side of the conversation.
class SpeechSurvey::Side {
 public:
  void add(const wire::Message& message) {
    ++messages_;
    const auto frame = wire::read_voice_frame(*message.payload);
    if (!frame) return;
    follow(*frame);
    const SessionTime at = spoken_at(*frame, message.published);
    for (const codec::VoicePacket& packet : packets_of(*frame)) {
      if (packet.number <= newest_) continue;
      newest_ = packet.number;
      const auto samples = decoder_.decode(std::as_bytes(std::span(packet.opus)));
      if (samples) spans_.add(at - std::int64_t{frame->number() - packet.number} * kVoiceFrameTime, level_dB(*samples));
    }
  }
  [[nodiscard]] SideSpeech speech() const { return {.spans = spans_.spans(), .messages = messages_}; }

 private:
  /// Begins again if another talker speaks, or the same one counts anew.
  void follow(const msg::VoiceFrame& frame) {
    const std::int64_t on = std::int64_t{frame.number()} - newest_;
    if (frame.talker() == talker_ && on <= kMostOn && on >= -kMostBack) return;
    talker_ = frame.talker();
    newest_ = std::int64_t{frame.number()} - frame.earlier_size() - 1;
    decoder_.restart();
  }

  codec::VoiceDecoder decoder_;
  LoudSpans spans_;
  std::uint64_t talker_ = 0;
  std::int64_t newest_ = std::numeric_limits<std::int32_t>::min();  // number of the newest decoded frame
  std::uint64_t messages_ = 0;
};

SpeechSurvey::SpeechSurvey() = default;
SpeechSurvey::~SpeechSurvey() = default;
SpeechSurvey::SpeechSurvey(SpeechSurvey&&) noexcept = default;
SpeechSurvey& SpeechSurvey::operator=(SpeechSurvey&&) noexcept = default;

void SpeechSurvey::add(const wire::Message& message) {
  if (message.topic.spoken) sides_[message.topic.name].add(message);
}

Speech SpeechSurvey::speech() const {
  Speech speech;
  for (const auto& [topic, side] : sides_) speech.emplace(topic, side.speech());
  return speech;
}

}  // namespace telepalp::speech
