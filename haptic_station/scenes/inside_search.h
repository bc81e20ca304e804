#pragma once

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::scenes {

/// Unknown: the search ended before it was sure.
enum class Search { Inside, NothingInside, Unknown };

/// Whether a part of the box lies inside the solid: halves boxes, nearest to the solid first, until the middle of one
/// is inside, or the solid's Lipschitz bound excludes them all but for boxes under 10 um. Evaluates at most 20 000
/// points.
[[nodiscard]] Search find_inside(const solids::SolidTree& tree, const solids::Box& box);

}  // namespace telepalp::scenes
