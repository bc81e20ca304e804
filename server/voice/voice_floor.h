#pragma once

#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::voice {

/// Decides which of several viewers is heard where they speak on one topic: the first one, until it has sent nothing
/// for kSilent or has left. Two talkers mixed into one stream would be understood by nobody. Pure; owner: the server's
/// network thread.
class VoiceFloor {
 public:
  static constexpr std::chrono::milliseconds kSilent{300};

  /// `viewer` speaks at `now`. True: it is heard.
  [[nodiscard]] bool speaks(std::uint64_t viewer, SessionTime now) noexcept;
  void leave(std::uint64_t viewer) noexcept;

 private:
  std::uint64_t holder_ = 0;  // 0: nobody
  SessionTime heard_{};       // when the holder spoke last
};

}  // namespace telepalp::voice
