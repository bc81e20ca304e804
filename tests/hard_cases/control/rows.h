#pragma once

#include <vector>

#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {

/// Stiff effects, inclusions, friction and several contacts at once.
[[nodiscard]] std::vector<HardCase> contact_rows();
/// Changes of the patient's surface under the hand.
[[nodiscard]] std::vector<HardCase> surface_rows();
/// Movements of the hand, and faults of its tracker.
[[nodiscard]] std::vector<HardCase> hand_rows();
/// Wrong time stamps, and late or missing data.
[[nodiscard]] std::vector<HardCase> clock_rows();
/// Limits and faults of the device.
[[nodiscard]] std::vector<HardCase> device_rows();
/// A skin that moves, steps, ends or is not seen, through the live loop.
[[nodiscard]] std::vector<HardCase> moving_skin_rows();
/// Objects inside the body that are pushed through.
[[nodiscard]] std::vector<HardCase> inner_rows();
/// Needles in layers of tissue.
[[nodiscard]] std::vector<HardCase> needle_rows();
/// Objects inside a body that a camera sees move.
[[nodiscard]] std::vector<HardCase> body_rows();
/// Workspace indexing: the device leaves the cylinder in which it touches the body, and returns.
[[nodiscard]] std::vector<HardCase> indexing_rows();

}  // namespace telepalp::hard_cases
