#pragma once

#include <cstdint>
#include <span>

#include "haptic_station/surface/temporal/cell_gains.h"

namespace telepalp::surface {

/// Fills in the innovations of cells that an object hides: `shared_m[i]`, the cell's part of the motion that the whole
/// body shares, plus a plane fitted to the seen cells' motion beyond their parts. So the skin under the object rises,
/// tilts and breathes with the body. `hidden`: 1 for a cell to fill; empty: none. Cells that are seen do not change.
void fill_hidden(const CellLattice& lattice, std::span<const std::uint8_t> hidden, std::span<const double> shared_m,
                 std::span<CellInnovation> seen);

}  // namespace telepalp::surface
