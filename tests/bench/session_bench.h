#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Writes a session of 2 GB and plays it from its middle, cold and warm: time to the first depth image, and memory.
/// Then records a synthetic patient with the real programs for --seconds, and measures the recorder's processor time.
[[nodiscard]] Result<Report> run_session(const program::Arguments& arguments);

}  // namespace telepalp::bench
