#pragma once

#include "haptic_station/solids/solid_tree.h"
#include "support/isosurface/isosurface.h"

namespace telepalp::solids {

/// The tree as an implicit function without the seams of its differences (kSeam_m), with the size of each of its
/// shapes. Copies the tree.
[[nodiscard]] isosurface::Field field_of(const SolidTree& tree);

}  // namespace telepalp::solids
