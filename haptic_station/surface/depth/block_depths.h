#pragma once

#include <cstddef>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"

namespace telepalp::surface {

/// An image in blocks of kBlock_px × kBlock_px pixels: 6 mm wide at a depth of 0.8 m under a Kinect. Their mean depth
/// has a quarter of a pixel's noise.
struct BlockLattice {
  static constexpr int kBlock_px = 4;

  int columns = 0;
  int rows = 0;

  [[nodiscard]] std::size_t size() const noexcept {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] std::size_t at(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool contains(int column, int row) const noexcept {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
};

[[nodiscard]] BlockLattice blocks_of(int width_px, int height_px) noexcept;

/// Writes the mean depth [m] of each block's measured pixels to `out`; 0: fewer than half of the block are measured.
void block_depths(const DepthField& depth, const BlockLattice& lattice, std::vector<float>& out);

}  // namespace telepalp::surface
