#pragma once

#include "haptic_station/solids/solid_tree.h"
#include "support/isosurface/isosurface.h"

namespace telepalp::solids {

/// The tree as an implicit function, with the size of each of its shapes. The tree is borrowed.
[[nodiscard]] isosurface::Field field_of(const SolidTree& tree);

}  // namespace telepalp::solids
