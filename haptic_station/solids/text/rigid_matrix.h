#pragma once

#include <array>

#include "haptic_station/solids/solid.h"

namespace telepalp::solids {

/// Splits a 3 by 4 matrix, given row by row, into a rotation with a translation (node `tx`) and a uniform scaling (node
/// `sc`). `where`: the matrix's place in the text, for errors.
/// Error: the matrix shears, mirrors, or scales its axes differently, so that it does not keep distances in proportion.
[[nodiscard]] Result<Solid> placement_of(const std::array<double, 12>& matrix, const std::string& where);

}  // namespace telepalp::solids
