#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace telepalp::surface {

// Sums over windows of pixels: plain arrays and floats, so that compilers vectorise them. A pixel's value is its
// inverse depth minus a reference close to it. The difference is small, and so is its rounding (under 0.1 um of depth).

inline constexpr int kMostRadius = 15;
inline constexpr int kMostSide = 2 * kMostRadius + 1;  ///< one row of a window fits a 32-bit word
/// Number of pixels that are summed at once. The functions below may read and write up to this many floats behind the
/// end of an image or a row.
inline constexpr int kBlock = 8;

/// Weights (1 - (k/(r+1))^2)^2 at the distance k px from the centre, along one axis of a window of radius r, and
/// constants derived from them. A pixel's weight is the product over both axes; it falls smoothly to 0 at the window's
/// rim.
struct AxisWeights {
  int radius = 0;
  std::array<float, kMostRadius + 1> by_distance{};
  double m0 = 0.0;  ///< even moments: sums of the weights times k^0, k^2 and k^4, over both sides
  double m2 = 0.0;
  double m4 = 0.0;
  double gain = 0.0;  ///< variance of the fit at the centre / variance of one pixel
};
[[nodiscard]] AxisWeights axis_weights(int radius);

/// For each pixel of a row: value and slopes [per px], at this pixel, of the quadratic fitted to the window around it.
struct PlaneRow {
  float* at;
  float* across;
  float* down;
};

/// Scratch memory for one row; each array has one float per pixel.
struct ColumnMoments {
  float* m0;
  float* m1;
  float* m2;
};

/// Fits the windows around the pixels [radius, width - radius) of a row. A fit is meaningless if its window has a hole
/// or a depth break. `centre`: the row's first pixel; rows are `stride` floats apart.
void fit_whole_windows(const float* centre, std::ptrdiff_t stride, int width, const AxisWeights& axis,
                       const ColumnMoments& scratch, const PlaneRow& planes);

/// Sums over the pixels of one window that a mask selects, by the window's columns. w_l: weight of the row that lies l
/// pixels below the centre.
struct MaskedColumns {
  std::array<std::array<float, kMostSide + kBlock>, 5> weight;  ///< sums of w_l l^b over rows l, b = 0 ... 4
  std::array<std::array<float, kMostSide + kBlock>, 3> value;  ///< sums of w_l l^b times the pixel's value, b = 0 ... 2
};

/// Computes `sums` over one window of `image`. `first`: index of the window's top left pixel in `image`, whose rows are
/// `stride` floats apart. `mask`: one word for each row of the window, from the top; bit k selects column k. Only rows
/// with a selected pixel are read, and of these rows the columns [`from`, `to`) and up to kBlock columns behind them.
void sum_masked_columns(const float* image, std::ptrdiff_t first, std::ptrdiff_t stride, const std::uint32_t* mask,
                        const AxisWeights& axis, int from, int to, MaskedColumns& sums);

/// Writes the inverse depth minus `reference` [1/m] of one row of depths. An unmeasured pixel (depth 0) becomes 0.
void invert_row(const float* z_m, int width, float reference, float* per_m);

/// Sets the flags kBrokenRight, kBrokenBelow and kMeasured of window_fit.h for each pixel of a row. `below`: the next
/// row; for the image's last row, that row itself. `break_at_1m`: see break_at() in depth_field.h.
void mark_row(const float* z_m, const float* below, int width, float break_at_1m, std::uint8_t* marks);

/// Writes a bitmap of the pixels that have the flag `mark`: 64 pixels per word, the first pixel in bit 0.
void pack_row(const std::uint8_t* marks, int width, std::uint8_t mark, std::uint64_t* bits);

}  // namespace telepalp::surface
