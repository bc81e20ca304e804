#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// The station on this machine: how late the 2 kHz thread is woken, beside a thread that only waits, and how well
/// calibration by point pairs finds its way under the noise that S3 measured.
[[nodiscard]] Result<Report> run_station(const program::Arguments& arguments);

}  // namespace telepalp::bench
