#pragma once

#include <functional>

#include "tests/bench/distribution.h"
#include "tests/bench/site/touch_session.h"

namespace telepalp::bench {

/// The times of one run, in session time: other traffic from `began` until `ended`.
struct FlowTimes {
  Nanoseconds began{0}, ended{0};
  Nanoseconds alone{0};  ///< length of the time before `began` that is measured
  Nanoseconds after{0};  ///< length of the time after `ended` that is measured
};

/// What one session of touch got.
struct FlowOutcome {
  double images_per_s = 0.0;    ///< touchable, beside the other traffic
  Distribution above_queue_ms;  ///< captured to touchable, less the queueing delay when the image was captured
  Distribution touchable_ms;    ///< captured to touchable
  double released = 1.0;        ///< share of that time in which the station gave no force, as its inputs were too old
  double alone_B_per_s = 0.0;   ///< what the server sent to the station before
  double beside_B_per_s = 0.0;  ///< the same beside the other traffic
  double back_after_s = 0.0;    ///< from the other traffic's end until images come as often and as large as before
};

/// Pure. `queue_at`: the queueing delay at a time.
[[nodiscard]] FlowOutcome outcome_of(const TouchRecord& record, const FlowTimes& times,
                                     const std::function<Nanoseconds(Nanoseconds)>& queue_at);

}  // namespace telepalp::bench
