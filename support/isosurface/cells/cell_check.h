#pragma once

#include <optional>

#include "support/isosurface/cells/cell_samples.h"

namespace telepalp::isosurface {

/// What a cell's samples say about the surface in it.
struct CellCheck {
  bool simple = true;  ///< the corners' signs decide the surface's shape in the cell, and finer samples agree with them
  bool flat = true;    ///< planes that meet in one point fit the surface within kFlat of the side
  bool one_sheet = true;            ///< no two parts of the surface face each other in the cell, except beside an edge
  std::optional<double> apart_m{};  ///< distance between two sheets that are parallel

  [[nodiscard]] bool sure() const noexcept { return simple && one_sheet; }
};
inline constexpr double kFlat = 0.05;

[[nodiscard]] CellCheck check_cell(const CellSamples& samples);

}  // namespace telepalp::isosurface
