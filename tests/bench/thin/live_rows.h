#pragma once

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Adds figures of a hand and a doctor's picture over a thin line: a real server, a real impaired link, real sockets.
/// `input`: a --source of the server; empty: the recorded room and the synthetic patient.
[[nodiscard]] Result<void> add_live_rows(Report& report, const std::string& input);

}  // namespace telepalp::bench
