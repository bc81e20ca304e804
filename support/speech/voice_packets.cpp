#include "support/speech/voice_packets.h"

#include <algorithm>

namespace telepalp::speech {
namespace {

constexpr std::uint64_t kLatest_ns = std::uint64_t{1} << 62;  // of any session; peers may state any time

}  // namespace

std::vector<codec::VoicePacket> packets_of(const msg::VoiceFrame& frame) {
  const SessionTime spoken = session_time(static_cast<std::int64_t>(std::min(frame.captured_ns(), kLatest_ns)));
  std::vector<codec::VoicePacket> packets;
  for (int back = frame.earlier_size(); back >= 0; --back)
    packets.push_back({.talker = frame.talker(),
                       .number = frame.number() - static_cast<std::uint32_t>(back),
                       .begun = frame.begun(),
                       .opus = back == 0 ? frame.opus() : frame.earlier(back - 1),
                       .spoken = spoken - std::int64_t{back} * kVoiceFrameTime});
  return packets;
}

}  // namespace telepalp::speech
