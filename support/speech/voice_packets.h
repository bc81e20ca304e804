#pragma once

#include <vector>

#include "codec/voice_playout.h"
#include "messages/voice.pb.h"

namespace telepalp::speech {

/// The packets of a message that wire::read_voice_frame() accepted, the oldest first: those that it repeats, and its
/// own.
[[nodiscard]] std::vector<codec::VoicePacket> packets_of(const msg::VoiceFrame& frame);

}  // namespace telepalp::speech
