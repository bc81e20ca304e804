#pragma once

#include "clients/mixed/view/mask.h"

namespace telepalp::mixed {

/// Pixels of `mask` that a path of neighbours (4 a pixel) within `mask` joins to `marker`: morphological
/// reconstruction.
[[nodiscard]] Mask reconstructed(const Mask& marker, const Mask& mask);

/// `mask` without its holes: regions that are off and that no path of off pixels joins to the image's border.
[[nodiscard]] Mask with_holes_filled(const Mask& mask);

/// Pixels whose whole square of 2 radius_px + 1 pixels a side is on. Pixels beyond the image's border count as
/// on.
[[nodiscard]] Mask eroded(const Mask& mask, int radius_px);

/// The segmentation's clean-up. Paper S3 (docs/sources.md) 5.3: hole filling, erosion, opening by reconstruction.
struct CleanUp {
  int erosion_px = 0;  ///< S3 erodes, which makes the hand smaller; 0 keeps its outline
  int opening_px = 2;  ///< parts that the erosion by this radius removes wholly are noise
};

[[nodiscard]] Mask cleaned(const Mask& mask, const CleanUp& how);

}  // namespace telepalp::mixed
