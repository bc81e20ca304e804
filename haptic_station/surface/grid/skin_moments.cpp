#include "haptic_station/surface/grid/skin_moments.h"

#include "proto/words/vectorised.h"

// Compiled for several instruction sets. This file must not use inline functions of headers that other files compile
// for another instruction set.

namespace telepalp::surface {
namespace {

using Block [[gnu::vector_size(4 * kBlock)]] = float;
using Bits [[gnu::vector_size(4 * kBlock)]] = std::uint32_t;

constexpr int kWeights = 15;
constexpr int kHeights = 6;

using Half [[gnu::vector_size(4 * kBlock / 2)]] = float;
using Quarter [[gnu::vector_size(8 * kBlock / 2)]] = double;

/// The sum of the eight lanes, always in the same order.
[[gnu::always_inline]] inline double sum_of(const Block& block) {
  Half low, high;
  __builtin_memcpy(&low, &block, sizeof low);
  __builtin_memcpy(&high, reinterpret_cast<const char*>(&block) + sizeof low, sizeof high);
  const Quarter four = __builtin_convertvector(low, Quarter) + __builtin_convertvector(high, Quarter);
  return (four[0] + four[1]) + (four[2] + four[3]);
}

struct Sums {
  Block weight[kWeights];
  Block height[kHeights];
};

}  // namespace

TELEPALP_VECTORISED
void sum_on_skin(const SkinWindow& window, const SkinFrame& frame, SkinMoments& sums) {
  constexpr Bits kBit = {1, 2, 4, 8, 16, 32, 64, 128};
  constexpr Block kLane = {0, 1, 2, 3, 4, 5, 6, 7};
  const float* at = frame.at.data();
  const float* across = frame.across.data();
  const float* down = frame.down.data();
  const float* outwards = frame.outwards.data();
  Sums all = {};
  for (int row = window.top; row < window.bottom; ++row) {
    const float ray_y = window.ray_y + static_cast<float>(row) * window.ray_y_step;
    for (int k = window.left; k < window.right; k += kBlock) {
      const std::uint32_t selected = window.mask[row] >> k;
      if ((selected & 0xFFU) == 0) continue;
      Block z;
      __builtin_memcpy(&z, window.image + (window.first + row * window.stride + k), sizeof z);
      z = 1.0F / (z + window.reference_per_m);
      const Block ray_x = window.ray_x + (static_cast<float>(k) + kLane) * window.ray_x_step;
      const Block x = z * ray_x - at[0];
      const Block y = z * ray_y - at[1];
      z -= at[2];
      const Block u = x * across[0] + y * across[1] + z * across[2];
      const Block v = x * down[0] + y * down[1] + z * down[2];
      const Block h = x * outwards[0] + y * outwards[1] + z * outwards[2];
      const Block near = 1.0F - (u * u + v * v + h * h);
      const Block w = ((kBit & selected) != 0) & (near > 0.0F) ? near * near : Block{};
      const Block wu = w * u, wv = w * v;
      const Block wuu = wu * u, wuv = wu * v, wvv = wv * v;
      const Block uu = u * u, uv = u * v, vv = v * v;
      all.weight[0] += w;
      all.weight[1] += wu;
      all.weight[2] += wv;
      all.weight[3] += wuu;
      all.weight[4] += wuv;
      all.weight[5] += wvv;
      all.weight[6] += wuu * u;
      all.weight[7] += wuu * v;
      all.weight[8] += wvv * u;
      all.weight[9] += wvv * v;
      all.weight[10] += wuu * uu;
      all.weight[11] += wuu * uv;
      all.weight[12] += wuu * vv;
      all.weight[13] += wuv * vv;
      all.weight[14] += wvv * vv;
      all.height[0] += w * h;
      all.height[1] += wu * h;
      all.height[2] += wv * h;
      all.height[3] += wuu * h;
      all.height[4] += wuv * h;
      all.height[5] += wvv * h;
    }
  }
  double* const weight = sums.weight.data();
  double* const height = sums.height.data();
  for (int i = 0; i < kWeights; ++i) weight[i] = sum_of(all.weight[i]);
  for (int i = 0; i < kHeights; ++i) height[i] = sum_of(all.height[i]);
}

}  // namespace telepalp::surface
