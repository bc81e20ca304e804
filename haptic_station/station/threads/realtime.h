#pragma once

#include <string>

#include "proto/words/result.h"

namespace telepalp::station {

/// The option `--realtime`, for real-time priority and locked memory: `Require` refuses to start without both, `Prefer`
/// runs with what is granted.
enum class Realtime { Require, Prefer };

/// What the operating system granted. Each grant needs a capability (CAP_SYS_NICE, CAP_IPC_LOCK) or a resource limit.
struct RealtimeGrant {
  bool priority = false;       ///< SCHED_FIFO priority: no ordinary program delays a tick
  bool locked_memory = false;  ///< the process's memory stays in RAM: no page fault delays a tick
  [[nodiscard]] bool both() const noexcept { return priority && locked_memory; }
};

/// For the log, such as "with real-time priority, without locked memory".
[[nodiscard]] std::string in_words(const RealtimeGrant& grant);

/// Asks for SCHED_FIFO priority for the calling thread, and for locked memory for the process. Error, with Require
/// only: either is not granted.
[[nodiscard]] Result<RealtimeGrant> enter_realtime(Realtime wanted);

}  // namespace telepalp::station
