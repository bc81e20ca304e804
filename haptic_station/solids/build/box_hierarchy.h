#pragma once

#include <vector>

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// Adds a bounding-box hierarchy over a union's members (node indices) to `tree`. Each box is split at the median
/// member along its longest side, and each half once more. Returns the index of the root in tree.boxes; kNothing
/// without members.
[[nodiscard]] std::uint32_t add_hierarchy(SolidTree& tree, std::vector<std::uint32_t> members);

}  // namespace telepalp::solids
