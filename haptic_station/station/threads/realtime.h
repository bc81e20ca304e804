#pragma once

#include "proto/words/result.h"

namespace telepalp::station {

/// What the operator asked of the machine: `Require` refuses to start without real-time scheduling, `Prefer` says
/// that it runs without.
enum class Realtime { Require, Prefer };

/// Gives the calling thread SCHED_FIFO priority and locks the process's memory, so that neither another program nor
/// a page fault delays a tick. True: granted. False (only with Prefer): not granted, carry on.
[[nodiscard]] Result<bool> enter_realtime(Realtime wanted);

}  // namespace telepalp::station
