#include "haptic_station/surface/grid/window_moments.h"

#include <algorithm>
#include <cstdlib>

#include "proto/words/vectorised.h"

// Compiled for several instruction sets. This file must not use inline functions of headers that other files compile
// for another instruction set.

namespace telepalp::surface {

AxisWeights axis_weights(int radius) {
  AxisWeights axis{.radius = std::clamp(radius, 1, kMostRadius)};
  const int r = axis.radius;
  for (int k = 0; k <= r; ++k) {
    const double t = static_cast<double>(k) / (r + 1);
    axis.by_distance[static_cast<std::size_t>(k)] = static_cast<float>((1.0 - t * t) * (1.0 - t * t));
  }
  const auto weight = [&](int k) {
    return static_cast<double>(axis.by_distance[static_cast<std::size_t>(std::abs(k))]);
  };
  for (int k = -r; k <= r; ++k) {
    const double square = static_cast<double>(k) * k;
    axis.m0 += weight(k);
    axis.m2 += weight(k) * square;
    axis.m4 += weight(k) * square * square;
  }
  const double mean = axis.m2 / axis.m0;
  const double spread = axis.m4 - axis.m2 * mean;
  for (int l = -r; l <= r; ++l)
    for (int k = -r; k <= r; ++k) {
      const double bend = (k * k - mean + l * l - mean) * mean / (spread * axis.m0);
      const double tap = weight(k) * weight(l) * (1.0 / (axis.m0 * axis.m0) - bend);
      axis.gain += tap * tap;
    }
  return axis;
}

namespace {

/// Pixels that are summed at once, in one register where the processor has AVX2.
using Block [[gnu::vector_size(4 * kBlock)]] = float;

/// For each column, the moments l^0, l^1 and l^2 over the window's rows l.
TELEPALP_VECTORISED
void sum_columns(const float* __restrict centre, std::ptrdiff_t stride, int width, const AxisWeights& axis,
                 float* __restrict m0, float* __restrict m1, float* __restrict m2) {
  const float w0 = axis.by_distance[0];
  for (int u = 0; u < width; ++u) {
    m0[u] = w0 * centre[u];
    m1[u] = 0.0F;
    m2[u] = 0.0F;
  }
  for (int l = 1; l <= axis.radius; ++l) {
    const float w = axis.by_distance[static_cast<std::size_t>(l)];
    const float wl = w * static_cast<float>(l);
    const float wll = wl * static_cast<float>(l);
    const float* __restrict below = centre + l * stride;
    const float* __restrict above = centre - l * stride;
    for (int u = 0; u < width; ++u) {
      const float both = below[u] + above[u];
      m0[u] += w * both;
      m1[u] += wl * (below[u] - above[u]);
      m2[u] += wll * both;
    }
  }
}

/// The moments along the row, and the fitted quadratic: least squares over a symmetric window in closed form. A block
/// of pixels keeps its four sums in registers. Each pixel's sums are added in the order of k, in blocks of any size.
TELEPALP_VECTORISED
void fit_rows(const ColumnMoments& columns, int width, const AxisWeights& axis, const PlaneRow& planes) {
  const int radius = axis.radius;
  const float* __restrict weights = axis.by_distance.data();
  const auto mean = static_cast<float>(axis.m2 / axis.m0);
  const auto per_weight = static_cast<float>(1.0 / (axis.m0 * axis.m0));
  const auto per_slope = static_cast<float>(1.0 / (axis.m2 * axis.m0));
  const auto per_bend = static_cast<float>(1.0 / ((axis.m4 - axis.m2 * axis.m2 / axis.m0) * axis.m0));
  Block after, before, after_1, before_1, after_2, before_2;
  for (int u = radius; u < width - radius; u += kBlock) {
    const float* m0 = columns.m0 + u;
    const float* m1 = columns.m1 + u;
    const float* m2 = columns.m2 + u;
    __builtin_memcpy(&after, m0, sizeof after);
    __builtin_memcpy(&after_1, m1, sizeof after);
    __builtin_memcpy(&after_2, m2, sizeof after);
    Block at = weights[0] * after;
    Block across = {};
    Block down = weights[0] * after_1;
    Block square = weights[0] * after_2;
    for (int k = 1; k <= radius; ++k) {
      const float w = weights[k];
      const float wk = w * static_cast<float>(k);
      const float wkk = wk * static_cast<float>(k);
      __builtin_memcpy(&after, m0 + k, sizeof after);
      __builtin_memcpy(&before, m0 - k, sizeof before);
      __builtin_memcpy(&after_1, m1 + k, sizeof after);
      __builtin_memcpy(&before_1, m1 - k, sizeof before);
      __builtin_memcpy(&after_2, m2 + k, sizeof after);
      __builtin_memcpy(&before_2, m2 - k, sizeof before);
      const Block both = after + before;
      at += w * both;
      across += wk * (after - before);
      down += w * (after_1 + before_1);
      square += wkk * both + w * (after_2 + before_2);
    }
    const Block bend = (square - 2.0F * mean * at) * per_bend;
    at = at * per_weight - mean * bend;
    across *= per_slope;
    down *= per_slope;
    __builtin_memcpy(planes.at + u, &at, sizeof at);
    __builtin_memcpy(planes.across + u, &across, sizeof across);
    __builtin_memcpy(planes.down + u, &down, sizeof down);
  }
}

}  // namespace

void fit_whole_windows(const float* centre, std::ptrdiff_t stride, int width, const AxisWeights& axis,
                       const ColumnMoments& scratch, const PlaneRow& planes) {
  sum_columns(centre, stride, width, axis, scratch.m0, scratch.m1, scratch.m2);
  fit_rows(scratch, width, axis, planes);
}

namespace {

using Bits [[gnu::vector_size(4 * kBlock)]] = std::uint32_t;

/// The sums of a window's columns from `from` on, as many as a block has. A block keeps its eight sums in registers.
TELEPALP_VECTORISED
void sum_masked_block(const float* image, std::ptrdiff_t first, std::ptrdiff_t stride, const std::uint32_t* mask,
                      const AxisWeights& axis, int from, MaskedColumns& sums) {
  constexpr Bits kBit = {1, 2, 4, 8, 16, 32, 64, 128};
  const float* weights = axis.by_distance.data();
  Block w0 = {}, w1 = {}, w2 = {}, w3 = {}, w4 = {}, v0 = {}, v1 = {}, v2 = {};
  for (int row = 0; row <= 2 * axis.radius; ++row) {
    if (mask[row] == 0) continue;
    const int distance = row - axis.radius;
    const auto l = static_cast<float>(distance);
    const float w = weights[distance < 0 ? -distance : distance];
    Block value;
    __builtin_memcpy(&value, image + (first + row * stride + from), sizeof value);
    const Block in = (kBit & (mask[row] >> from)) != 0 ? Block{} + w : Block{};
    value *= in;
    const Block in1 = in * l;
    const Block in2 = in1 * l;
    const Block in3 = in2 * l;
    const Block value1 = value * l;
    w0 += in;
    w1 += in1;
    w2 += in2;
    w3 += in3;
    w4 += in3 * l;
    v0 += value;
    v1 += value1;
    v2 += value1 * l;
  }
  __builtin_memcpy(sums.weight[0].data() + from, &w0, sizeof w0);
  __builtin_memcpy(sums.weight[1].data() + from, &w1, sizeof w1);
  __builtin_memcpy(sums.weight[2].data() + from, &w2, sizeof w2);
  __builtin_memcpy(sums.weight[3].data() + from, &w3, sizeof w3);
  __builtin_memcpy(sums.weight[4].data() + from, &w4, sizeof w4);
  __builtin_memcpy(sums.value[0].data() + from, &v0, sizeof v0);
  __builtin_memcpy(sums.value[1].data() + from, &v1, sizeof v1);
  __builtin_memcpy(sums.value[2].data() + from, &v2, sizeof v2);
}

}  // namespace

void sum_masked_columns(const float* image, std::ptrdiff_t first, std::ptrdiff_t stride, const std::uint32_t* mask,
                        const AxisWeights& axis, int from, int to, MaskedColumns& sums) {
  for (int k = from; k < to; k += kBlock) sum_masked_block(image, first, stride, mask, axis, k, sums);
}

TELEPALP_VECTORISED
void invert_row(const float* __restrict z_m, int width, float reference, float* __restrict per_m) {
  for (int u = 0; u < width; ++u) {
    const float inverse = 1.0F / z_m[u] - reference;
    per_m[u] = z_m[u] > 0.0F ? inverse : 0.0F;
  }
}

namespace {

/// Marks of the pixels that have a right neighbour.
TELEPALP_VECTORISED
void mark_pairs(const float* __restrict z_m, const float* __restrict below, int count, float break_at_1m,
                std::uint8_t* __restrict marks) {
  for (int u = 0; u < count; ++u) {
    const float z = z_m[u];
    const float right = z_m[u + 1];
    const float down = below[u];
    const float near_right = z < right ? z : right;
    const float near_down = z < down ? z : down;
    const float step_right = z < right ? right - z : z - right;
    const float step_down = z < down ? down - z : z - down;
    // An unmeasured neighbour (0) is no depth break.
    const bool broken_right =
        (near_right > 0.0F) & (step_right > break_at_1m * (0.5F + 0.5F * near_right * near_right));
    const bool broken_down = (near_down > 0.0F) & (step_down > break_at_1m * (0.5F + 0.5F * near_down * near_down));
    const int bits = (z > 0.0F ? 4 : 0) | (broken_right ? 1 : 0) | (broken_down ? 2 : 0);
    marks[u] = static_cast<std::uint8_t>(bits);
  }
}

}  // namespace

void mark_row(const float* z_m, const float* below, int width, float break_at_1m, std::uint8_t* marks) {
  mark_pairs(z_m, below, width - 1, break_at_1m, marks);
  const float last[2] = {z_m[width - 1],
                         z_m[width - 1]};  // the last pixel has no right neighbour and is compared with itself
  mark_pairs(last, below + width - 1, 1, break_at_1m, marks + width - 1);
}

namespace {

/// Bit 0 of each of eight bytes, gathered into one byte: the factor moves bit 8 i to bit 56 + i, without a carry.
std::uint64_t gathered(std::uint64_t bytes) noexcept {
  return ((bytes & 0x0101010101010101U) * 0x0102040810204080U) >> 56U;
}

}  // namespace

void pack_row(const std::uint8_t* marks, int width, std::uint8_t mark, std::uint64_t* bits) {
  const int shift = __builtin_ctz(mark);
  for (int word = 0; word * 64 < width; ++word) {
    std::uint64_t packed = 0;
    const int first = word * 64;
    const int count = std::min(64, width - first);
    int u = 0;
    for (; u + 8 <= count; u += 8) {
      std::uint64_t eight = 0;
      __builtin_memcpy(&eight, marks + first + u, sizeof eight);
      packed |= gathered(eight >> shift) << u;
    }
    for (; u < count; ++u) packed |= static_cast<std::uint64_t>((marks[first + u] & mark) != 0) << u;
    bits[word] = packed;
  }
}

}  // namespace telepalp::surface
