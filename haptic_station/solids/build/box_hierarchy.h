#pragma once

#include <vector>

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// Adds a hierarchy over the boxes of the members, halved at the median along the longest side. Returns its root;
/// kNothing without members.
[[nodiscard]] std::uint32_t add_hierarchy(SolidTree& tree, std::vector<std::uint32_t> members);

}  // namespace telepalp::solids
