#pragma once

#include <cstddef>
#include <vector>

#include "proto/words/time.h"

namespace telepalp::codec {

/// How long speech waits in its jitter buffer to be heard together with the picture of its instant. The picture never
/// waits for the speech, because the hand follows the picture. Speech that comes later than the picture is heard when
/// it comes. Pure.
class LipSync {
 public:
  /// Speech is not held longer for a slow picture: then an answer in time matters more than lips.
  static constexpr Nanoseconds kMostHeld = std::chrono::milliseconds(200);

  /// A picture is shown that was captured `age` ago.
  void shown(Nanoseconds age);

  /// The delay in the jitter buffer that makes speech as old as the picture. `fastest`: how old the fastest frames of
  /// speech are when they arrive (VoicePlayout::fastest_age()). From 0 to kMostHeld; 0 before the first picture.
  [[nodiscard]] Nanoseconds delay(Nanoseconds fastest) const;

 private:
  static constexpr std::size_t kPictures = 90;  // three seconds

  std::vector<Nanoseconds> ages_;  // of the newest pictures; a ring
  std::size_t newest_ = 0;         // its place in the ring
};

}  // namespace telepalp::codec
