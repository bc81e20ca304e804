#include "tests/support/spoken_messages.h"

#include <deque>

#include "proto/wire/voice/voice_message.h"
#include "tests/support/speech.h"

namespace telepalp::support {

std::vector<wire::Message> spoken_messages(const wire::Topic& topic, SessionTime begin, std::uint32_t from,
                                           std::uint32_t until, std::uint64_t talker) {
  codec::VoiceEncoder encoder;
  std::deque<std::string> earlier;  // the newest first
  std::vector<wire::Message> messages;
  for (std::uint32_t number = from; number < until; ++number) {
    const SessionTime spoken = begin + std::int64_t{number} * kVoiceFrameTime;
    msg::VoiceFrame frame;
    frame.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(spoken)));
    frame.set_talker(talker);
    frame.set_number(number);
    frame.set_begun(from);
    frame.set_opus(encoder.encode(speech(number)));
    for (const std::string& packet : earlier) frame.add_earlier(packet);
    earlier.push_front(frame.opus());
    if (earlier.size() > wire::kMaxEarlierVoicePackets) earlier.pop_back();
    messages.push_back(wire::make_message(topic, spoken + kVoiceFrameTime, frame));
  }
  return messages;
}

}  // namespace telepalp::support
