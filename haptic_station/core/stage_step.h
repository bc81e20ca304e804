#pragma once

#include <cstdint>
#include <functional>

#include "proto/words/time.h"

namespace telepalp::core {

/// The instants of a stage's run whose times its result depends on or reports.
enum class StageStep : std::uint8_t {
  Decoded,  ///< the message is decoded
  Placed,   ///< the scene is placed in the image, and building begins
  Done      ///< the result is ready to be handed over
};

/// The session time of a step. A driver reads its clock, adds virtual costs, or looks up recorded times. A stage asks
/// for each step at most once in a run, in the order of the enumerators.
using StepTime = std::function<SessionTime(StageStep)>;

}  // namespace telepalp::core
