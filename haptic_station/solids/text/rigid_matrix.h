#pragma once

#include <array>

#include "haptic_station/solids/solid.h"

namespace telepalp::solids {

/// A 3 by 4 matrix, row by row, as a `tx` node and an `sc` node in front of the operand.
/// Error: the matrix shears, mirrors, or scales its axes differently, so distances in it would not be distances.
[[nodiscard]] Result<Solid> placement_of(const std::array<double, 12>& matrix, const std::string& where);

}  // namespace telepalp::solids
