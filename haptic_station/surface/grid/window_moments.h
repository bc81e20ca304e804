#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace telepalp::surface {

// Sums over windows of pixels: plain arrays and floats, so that compilers vectorise them. Values are inverse depths
// less a reference near them: what is left is small, and so is its rounding (under 0.1 um of depth).

inline constexpr int kMostRadius = 15;
inline constexpr int kMostSide = 2 * kMostRadius + 1;  ///< a window's row of pixels is a word of 32 bits

/// Weights along one axis, (1 - (k/(r+1))^2)^2, and what follows from them: a separable window, smooth to its rim.
struct AxisWeights {
  int radius = 0;
  std::array<float, kMostRadius + 1> by_distance{};
  double m0 = 0.0;  ///< the weights' even moments
  double m2 = 0.0;
  double m4 = 0.0;
  double gain = 0.0;  ///< variance of the fitted centre over a pixel's
};
[[nodiscard]] AxisWeights axis_weights(int radius);

/// A quadratic's value and slopes at the centre of a whole window, for each pixel of a row.
struct PlaneRow {
  float* at;
  float* across;
  float* down;
};

/// Scratch for one row: as many floats as the row has pixels, each.
struct ColumnMoments {
  float* m0;
  float* m1;
  float* m2;
  float* square;
};

/// Fits whole windows around the pixels [radius, width - radius) of a row. `centre`: the row's first pixel, its
/// neighbours above and below `stride` apart.
void fit_whole_windows(const float* centre, std::ptrdiff_t stride, int width, const AxisWeights& axis,
                       const ColumnMoments& scratch, const PlaneRow& planes);

/// Sums over the pixels of one window that a mask lets in, by the window's columns.
struct MaskedColumns {
  std::array<std::array<float, kMostSide + 1>, 5> weight;  ///< of w_l l^b, b = 0 ... 4
  std::array<std::array<float, kMostSide + 1>, 3> value;   ///< the same times the pixel's value, b = 0 ... 2
};

/// `first`: index of the window's top left pixel in `image`; `mask[l]`: bit k lets in pixel (k, l). Only columns from
/// `from` to before `to`, and rows that let in any, are read.
void sum_masked_columns(const float* image, std::ptrdiff_t first, std::ptrdiff_t stride, const std::uint32_t* mask,
                        const AxisWeights& axis, int from, int to, MaskedColumns& sums);

/// Inverse depth less `reference` of one row of depths; what is not measured (0) becomes 0.
void invert_row(const float* z_m, int width, float reference, float* per_m);

/// What each pixel of a row is, in the bits of window_fit.h. `below`: the next row, or the same where there is none.
/// `break_at_1m`: as of break_at(), the depth step that ends a surface.
void mark_row(const float* z_m, const float* below, int width, float break_at_1m, std::uint8_t* marks);

/// Which pixels of a row carry a mark, 64 to a word, bit 0 first.
void pack_row(const std::uint8_t* marks, int width, std::uint8_t mark, std::uint64_t* bits);

}  // namespace telepalp::surface
