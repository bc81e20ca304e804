#pragma once

#include <span>

#include "haptic_station/surface/depth/block_depths.h"

namespace telepalp::surface {

/// How far the whole body has come nearer to the camera by rising and tilting, linear over the image. The shape of a
/// breath is left out, because it is small compared with the objects that HiddenSkin looks for.
struct BodyMotion {
  double nearer_m = 0.0;      ///< at the image's middle
  double per_column_m = 0.0;  ///< change of the motion from one column of blocks to the next
  double per_row_m = 0.0;
  double off_m = 0.0;  ///< root mean square of the deviations of those blocks that follow the motion within 15 mm;
                       ///< infinite: none does

  double middle_column = 0.0;
  double middle_row = 0.0;
  [[nodiscard]] double at(int column, int row) const noexcept {
    return nearer_m + per_column_m * (column - middle_column) + per_row_m * (row - middle_row);
  }
};

/// Fits the motion to the blocks' depths `before_m` and `seen_m`; 0: unknown, such a block is left out. Outliers
/// have no weight (Tukey's biweight, starting at the median) as long as they are fewer than half of the blocks.
[[nodiscard]] BodyMotion body_motion(const BlockLattice& lattice, std::span<const float> before_m,
                                     std::span<const float> seen_m);

}  // namespace telepalp::surface
