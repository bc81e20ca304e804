#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// The station on this machine: the lateness of the 2 kHz thread, compared with a thread that only waits, and the
/// accuracy of calibration by point pairs under the noise that S3 measured.
[[nodiscard]] Result<Report> run_station(const program::Arguments& arguments);

}  // namespace telepalp::bench
