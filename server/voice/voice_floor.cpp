#include "server/voice/voice_floor.h"

namespace telepalp::voice {

bool VoiceFloor::speaks(std::uint64_t viewer, SessionTime now) noexcept {
  if (holder_ != 0 && holder_ != viewer && now - heard_ < kSilent) return false;
  holder_ = viewer;
  heard_ = now;
  return true;
}

void VoiceFloor::leave(std::uint64_t viewer) noexcept {
  if (holder_ == viewer) holder_ = 0;
}

}  // namespace telepalp::voice
