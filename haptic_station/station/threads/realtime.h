#pragma once

#include "proto/words/result.h"

namespace telepalp::station {

/// The option `--realtime`: `Require` refuses to start without real-time scheduling, `Prefer` logs a warning and runs
/// without it.
enum class Realtime { Require, Prefer };

/// Gives the calling thread SCHED_FIFO priority and locks the process's memory, so that neither another program nor
/// a page fault delays a tick. True: granted. False: not granted, with Prefer. Error: not granted, with Require.
[[nodiscard]] Result<bool> enter_realtime(Realtime wanted);

}  // namespace telepalp::station
