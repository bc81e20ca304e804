#include "support/speech/voice_packets.h"

namespace telepalp::speech {

std::vector<codec::VoicePacket> packets_of(const msg::VoiceFrame& frame) {
  std::vector<codec::VoicePacket> packets;
  for (int back = frame.earlier_size(); back >= 0; --back)
    packets.push_back({.talker = frame.talker(),
                       .number = frame.number() - static_cast<std::uint32_t>(back),
                       .begun = frame.begun(),
                       .opus = back == 0 ? frame.opus() : frame.earlier(back - 1)});
  return packets;
}

}  // namespace telepalp::speech
