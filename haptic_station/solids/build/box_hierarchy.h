#pragma once

#include <vector>

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// Adds a bounding-box hierarchy over a union's bounded members (indices in tree.nodes) to `tree`. Each set of members
/// is split at its median along the longest side of its box, and each half once more: four children per node. Returns
/// the index of the root in tree.boxes; kNothing without members.
[[nodiscard]] std::uint32_t add_hierarchy(SolidTree& tree, std::vector<std::uint32_t> members);

}  // namespace telepalp::solids
