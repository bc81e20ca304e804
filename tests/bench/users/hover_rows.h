#pragma once

#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// A pointer that sweeps over the synthetic patient without a button, up to 3 m/s, and presses after each sweep, in
/// virtual time. Defects that fail these rows: a hand that goes straight through the patient, one that stays where it
/// is, one that jumps, and one that presses before it has arrived.
[[nodiscard]] Result<std::vector<Row>> hover_rows();

}  // namespace telepalp::bench
