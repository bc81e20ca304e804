#pragma once

#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::bench::link {

struct ClockOutcome {
  Nanoseconds worst_error{0};   ///< of the session clock, from the tenth to the twentieth second
  std::uint64_t backwards = 0;  ///< readings that were earlier than the reading before
};

/// A client's session clock over a symmetric path, by the probes of a ClientLink; the worst of `runs` seeds. The
/// client's oscillator is 50 ppm off. In virtual time.
[[nodiscard]] ClockOutcome run_clock(Nanoseconds one_way, Nanoseconds jitter, std::uint64_t runs);

}  // namespace telepalp::bench::link
