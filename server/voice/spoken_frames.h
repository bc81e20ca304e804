#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "proto/wire/message.h"
#include "server/voice/alsa/room_microphone.h"

namespace telepalp::voice {

/// Makes the messages of /patient/voice of what the room's microphone hears, each with the packets before it. Pure.
class SpokenFrames {
 public:
  explicit SpokenFrames(std::uint64_t talker) noexcept : talker_(talker) {}

  [[nodiscard]] wire::Message message_of(HeardFrame heard, SessionTime now);

 private:
  std::uint64_t talker_;
  std::uint32_t newest_ = 0;         // number of the first of earlier_
  std::deque<std::string> earlier_;  // packets, the newest first
};

}  // namespace telepalp::voice
