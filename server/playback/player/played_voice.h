#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "proto/wire/message.h"

namespace telepalp::playback {

/// Prepares recorded speech for listeners. A listener plays one frame each 20 ms, so speech is published only at speed
/// 1. After each jump of the playback (a seek, another speed, the end of a pause) the talkers get new numbers, by which
/// a listener drops the frames that it still has from the place before. Pure; owner: the player's thread.
class PlayedVoice {
 public:
  /// The playback goes on at another place or at another pace.
  void jumped() noexcept;

  /// The message as it is published: `retimed`, of a spoken topic, with the talker's new number and without what was
  /// said before the jump. nullopt: it is not speech, or nothing of it came after the jump.
  [[nodiscard]] std::optional<wire::Message> as_played(const wire::Message& retimed);

 private:
  /// Where a talker began to be heard after a jump.
  struct Begun {
    std::uint64_t talker = 0;
    std::uint32_t number = 0;  ///< of the first frame
  };
  std::uint64_t jumps_ = 1;
  std::map<std::string_view, Begun> begun_;  // by topic
};

}  // namespace telepalp::playback
