#pragma once

#include <vector>

#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {

/// Stiff things, inclusions, friction and several contacts at once.
[[nodiscard]] std::vector<HardCase> contact_rows();
/// What the patient's surface may do under the hand.
[[nodiscard]] std::vector<HardCase> surface_rows();
/// What the hand may do, and what its tracker may tell.
[[nodiscard]] std::vector<HardCase> hand_rows();
/// Times that are wrong, late or missing.
[[nodiscard]] std::vector<HardCase> clock_rows();
/// What the device can not give.
[[nodiscard]] std::vector<HardCase> device_rows();
/// A skin that moves, steps, ends or is not seen, through the live loop.
[[nodiscard]] std::vector<HardCase> moving_skin_rows();

}  // namespace telepalp::hard_cases
