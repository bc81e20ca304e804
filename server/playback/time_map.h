#pragma once

#include <cmath>

#include "proto/words/time.h"

namespace telepalp::playback {

/// Maps instants of a recording to the session time at which they are played. The map is affine, so that ages in the
/// recording stay consistent. At speed 1 the differences of instants are exact to the nanosecond.
struct TimeMap {
  SessionTime recorded{};  ///< this instant of the recording …
  SessionTime now{};       ///< … is played at this one
  double speed = 1.0;

  [[nodiscard]] SessionTime operator()(SessionTime at) const noexcept {
    const Nanoseconds since = at - recorded;
    if (speed == 1.0) return now + since;
    return now + Nanoseconds(std::llround(static_cast<double>(since.count()) / speed));
  }
};

}  // namespace telepalp::playback
