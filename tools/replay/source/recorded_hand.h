#pragma once

#include <vector>

#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::replay {

/// One instant of a recorded hand, in the replay's session time.
struct RecordedInstant {
  SessionTime at;
  Point<HapticBase> device;
  Point<HapticBase> hand;
};
using RecordedHand = std::vector<RecordedInstant>;  ///< in order of time

}  // namespace telepalp::replay
