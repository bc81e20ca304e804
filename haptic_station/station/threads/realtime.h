#pragma once

#include <string>

#include "proto/words/result.h"

namespace telepalp::station {

/// The option `--realtime`: `Require` refuses to start without real-time scheduling, `Prefer` logs a warning and runs
/// without it.
enum class Realtime { Require, Prefer };

/// The operating system grants real-time priority and locked memory separately: each needs its own right.
struct RealtimeGrant {
  bool priority = false;       ///< SCHED_FIFO priority: no ordinary program delays a tick
  bool locked_memory = false;  ///< the process's memory stays in RAM: no page fault delays a tick
  [[nodiscard]] bool both() const noexcept { return priority && locked_memory; }
};

/// "with real-time priority, without locked memory"
[[nodiscard]] std::string in_words(const RealtimeGrant& grant);

/// Asks for SCHED_FIFO priority for the calling thread, and for locked memory for the process. Error: one of them is
/// not granted, with Require.
[[nodiscard]] Result<RealtimeGrant> enter_realtime(Realtime wanted);

}  // namespace telepalp::station
