#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptic_station/surface/depth/block_depths.h"

namespace telepalp::surface {

/// What one image shows of the blocks, beside the remembered skin.
struct SeenBlocks {
  std::span<const float> depth_m;        ///< of this image; 0: not measured
  std::span<const float> remembered_m;   ///< depth of the remembered skin, carried by the body's motion; 0: unknown
  std::span<const std::uint8_t> hidden;  ///< 1: an object lay over the block in the last image
};

/// A connected part of the image that lies nearer than the remembered skin, with the figures that distinguish an object
/// from skin.
struct NearerRegion {
  std::vector<std::uint32_t> blocks;
  int hidden = 0;  ///< blocks of it over which an object lay in the last image
  int edges = 0;   ///< places of its rim where depth steps up to it, and the remembered skin has no such step
  int smooth = 0;  ///< places of its rim where the surface goes on without a step
};

inline constexpr double kNearer_m = 0.015;  ///< a patient's skin moves less beside the body's common motion
inline constexpr double kStaysNearer_m = 0.007;
inline constexpr double kGrown_m = 0.005;  ///< above the noise of a block's mean, and above what a breath leaves

/// The regions in which a block is at least kNearer_m nearer than the remembered skin (kStaysNearer_m, if an object lay
/// over it), each grown to all connected blocks that are at least kGrown_m nearer.
[[nodiscard]] std::vector<NearerRegion> nearer_regions(const BlockLattice& lattice, const SeenBlocks& seen);

}  // namespace telepalp::surface
