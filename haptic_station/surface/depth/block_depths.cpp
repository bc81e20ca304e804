#include "haptic_station/surface/depth/block_depths.h"

#include <algorithm>

namespace telepalp::surface {
namespace {

constexpr int kBlockSide = BlockLattice::kBlock_px;

}  // namespace

BlockLattice blocks_of(int width_px, int height_px) noexcept {
  return {(width_px + kBlockSide - 1) / kBlockSide, (height_px + kBlockSide - 1) / kBlockSide};
}

void block_depths(const DepthField& depth, const BlockLattice& lattice, std::vector<float>& out) {
  const auto width = static_cast<std::size_t>(depth.width);
  out.resize(lattice.size());
  std::vector<float> sum(width + kBlockSide);
  std::vector<float> count(width + kBlockSide);
  for (int row = 0; row < lattice.rows; ++row) {
    std::fill(sum.begin(), sum.end(), 0.0F);
    std::fill(count.begin(), count.end(), 0.0F);
    const int bottom = std::min(depth.height, (row + 1) * kBlockSide);
    for (int v = row * kBlockSide; v < bottom; ++v) {
      const float* const z_m = &depth.z_m[depth.index(0, v)];
      for (std::size_t u = 0; u < width; ++u) {
        sum[u] += z_m[u];
        count[u] += z_m[u] > 0.0F ? 1.0F : 0.0F;
      }
    }
    for (int column = 0; column < lattice.columns; ++column) {
      const auto u = static_cast<std::size_t>(column * kBlockSide);
      const float measured = count[u] + count[u + 1] + count[u + 2] + count[u + 3];
      const float depths_m = sum[u] + sum[u + 1] + sum[u + 2] + sum[u + 3];
      out[lattice.at(column, row)] = measured >= 0.5F * kBlockSide * kBlockSide ? depths_m / measured : 0.0F;
    }
  }
}

}  // namespace telepalp::surface
