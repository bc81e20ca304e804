#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Writes a session of 2 GB and plays it from its middle, cold and warm: time to the first depth image, and memory.
/// Then the real programs serve and touch a synthetic patient for --seconds, with and without a recorder in turns: the
/// processor time of recorder and server, and the ticks of the station.
[[nodiscard]] Result<Report> run_session(const program::Arguments& arguments);

}  // namespace telepalp::bench
