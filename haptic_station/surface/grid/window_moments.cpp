#include "haptic_station/surface/grid/window_moments.h"

#include <algorithm>
#include <cstdlib>

#include "proto/words/vectorised.h"

// Compiled for several instruction sets, without inline functions of headers that other files compile
// (filter_rows.cpp).

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

/// The moments along the row, and the fitted quadratic: least squares over a symmetric window in closed form. The
/// output rows also hold the intermediate sums.
TELEPALP_VECTORISED
void fit_rows(const ColumnMoments& columns, int width, const AxisWeights& axis, const PlaneRow& planes) {
  const float* __restrict m0 = columns.m0;
  const float* __restrict m1 = columns.m1;
  const float* __restrict m2 = columns.m2;
  float* __restrict square = columns.square;
  float* __restrict at = planes.at;
  float* __restrict across = planes.across;
  float* __restrict down = planes.down;
  const int radius = axis.radius;
  const float w0 = axis.by_distance[0];
  for (int u = radius; u < width - radius; ++u) {
    at[u] = w0 * m0[u];
    across[u] = 0.0F;
    down[u] = w0 * m1[u];
    square[u] = w0 * m2[u];
  }
  for (int k = 1; k <= radius; ++k) {
    const float w = axis.by_distance[static_cast<std::size_t>(k)];
    const float wk = w * static_cast<float>(k);
    const float wkk = wk * static_cast<float>(k);
    for (int u = radius; u < width - radius; ++u) {
      const float both = m0[u + k] + m0[u - k];
      at[u] += w * both;
      across[u] += wk * (m0[u + k] - m0[u - k]);
      down[u] += w * (m1[u + k] + m1[u - k]);
      square[u] += wkk * both + w * (m2[u + k] + m2[u - k]);
    }
  }
  const auto mean = static_cast<float>(axis.m2 / axis.m0);
  const auto per_weight = static_cast<float>(1.0 / (axis.m0 * axis.m0));
  const auto per_slope = static_cast<float>(1.0 / (axis.m2 * axis.m0));
  const auto per_bend = static_cast<float>(1.0 / ((axis.m4 - axis.m2 * axis.m2 / axis.m0) * axis.m0));
  for (int u = radius; u < width - radius; ++u) {
    const float bend = (square[u] - 2.0F * mean * at[u]) * per_bend;
    at[u] = at[u] * per_weight - mean * bend;
    across[u] *= per_slope;
    down[u] *= per_slope;
  }
}

}  // namespace

void fit_whole_windows(const float* centre, std::ptrdiff_t stride, int width, const AxisWeights& axis,
                       const ColumnMoments& scratch, const PlaneRow& planes) {
  sum_columns(centre, stride, width, axis, scratch.m0, scratch.m1, scratch.m2);
  fit_rows(scratch, width, axis, planes);
}

namespace {

constexpr auto kBit = [] {
  std::array<std::uint32_t, 32> bits{};
  for (std::size_t k = 0; k < bits.size(); ++k) bits[k] = std::uint32_t{1} << k;
  return bits;
}();

/// Adds one row of a window, from column `from` to before `to`.
TELEPALP_VECTORISED
void add_masked_row(const float* __restrict pixels, std::uint32_t mask, float w, float l, int from, int to,
                    MaskedColumns& sums) {
  float* __restrict w0 = sums.weight[0].data();
  float* __restrict w1 = sums.weight[1].data();
  float* __restrict w2 = sums.weight[2].data();
  float* __restrict w3 = sums.weight[3].data();
  float* __restrict w4 = sums.weight[4].data();
  float* __restrict v0 = sums.value[0].data();
  float* __restrict v1 = sums.value[1].data();
  float* __restrict v2 = sums.value[2].data();
  const std::uint32_t* __restrict bit = kBit.data();
  for (int k = from; k < to; ++k) {
    const float in = (mask & bit[k]) != 0 ? w : 0.0F;
    const float value = in * pixels[k - from];
    const float in1 = in * l;
    const float in2 = in1 * l;
    const float in3 = in2 * l;
    w0[k] += in;
    w1[k] += in1;
    w2[k] += in2;
    w3[k] += in3;
    w4[k] += in3 * l;
    v0[k] += value;
    v1[k] += value * l;
    v2[k] += value * l * l;
  }
}

}  // namespace

void sum_masked_columns(const float* image, std::ptrdiff_t first, std::ptrdiff_t stride, const std::uint32_t* mask,
                        const AxisWeights& axis, int from, int to, MaskedColumns& sums) {
  for (auto& column : sums.weight) column.fill(0.0F);
  for (auto& column : sums.value) column.fill(0.0F);
  for (int row = 0; row <= 2 * axis.radius; ++row) {
    if (mask[row] == 0) continue;
    const int distance = row - axis.radius;
    const float w = axis.by_distance[static_cast<std::size_t>(std::abs(distance))];
    add_masked_row(image + (first + row * stride + from), mask[row], w, static_cast<float>(distance), from, to, sums);
  }
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

void pack_row(const std::uint8_t* marks, int width, std::uint8_t mark, std::uint64_t* bits) {
  for (int word = 0; word * 64 < width; ++word) {
    std::uint64_t packed = 0;
    const int first = word * 64;
    const int count = std::min(64, width - first);
    for (int u = 0; u < count; ++u) packed |= static_cast<std::uint64_t>((marks[first + u] & mark) != 0) << u;
    bits[word] = packed;
  }
}

}  // namespace telepalp::surface
