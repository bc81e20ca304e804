#pragma once

#include <span>

#include "haptic_station/surface/depth/block_depths.h"

namespace telepalp::surface {

/// How the body has come nearer as a whole, as it rises and tilts: linear over the image. The breath's own shape is
/// left out, because it is small beside what it serves to judge.
struct BodyMotion {
  double nearer_m = 0.0;      ///< at the image's middle
  double per_column_m = 0.0;  ///< change of this value from one block to the next
  double per_row_m = 0.0;
  double off_m = 0.0;  ///< root mean square of the deviations of those blocks that follow the motion within 15 mm

  double middle_column = 0.0;
  double middle_row = 0.0;
  [[nodiscard]] double at(int column, int row) const noexcept {
    return nearer_m + per_column_m * (column - middle_column) + per_row_m * (row - middle_row);
  }
};

/// Fits the motion to the blocks' depths `before_m` and `seen_m`; 0: unknown, such a block is left out. Deviating
/// blocks do not count (Tukey's weights, from the median on), as long as they are fewer than half.
[[nodiscard]] BodyMotion body_motion(const BlockLattice& lattice, std::span<const float> before_m,
                                     std::span<const float> seen_m);

}  // namespace telepalp::surface
