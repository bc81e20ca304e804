#pragma once

namespace telepalp::surface {

// Functions for one row of pixels of the temporal filter. They use plain arrays, no branch that depends on a pixel, and
// sums by column, so that compilers vectorise them. The results are the same on every processor that rounds as IEEE 754
// requires.

/// The noise of the pixels.
struct PixelNoise {
  float scale = 1.0F;  ///< ratio of the measured noise to the noise model
};

/// Sums by column over the rows of a cell.
struct ColumnSums {
  float* innovation;  ///< measured minus expected [m]
  float* unit;        ///< size of the innovation over the noise model's sigma
  float* sigma;       ///< sigma of the noise model [m]
  float* count;
};

/// Adds the innovations of one row, `seen` − (`average` + `change`), at the pixels where both are known and the
/// innovation is no outlier.
void observe_row(const float* seen, const float* average, const float* change, int width, PixelNoise noise,
                 const ColumnSums& sums) noexcept;

/// A row's running average.
struct AverageRow {
  float* depth_m;  ///< 0: unknown
  float* frames;   ///< number of frames in the average
};

/// Sums by column over the rows of a patch.
struct LeanSums {
  float* lean;   ///< sum of residuals, each scaled to unit variance under noise alone
  float* count;  ///< number of residuals
};

/// Moves the average by `moved` and updates it with `seen`. Residuals are relative to `expected`, which includes the
/// whole innovation of the cells, because motion that the cells follow must not count as a residual of the pixels.
void update_row(const float* seen, const float* moved, const float* expected, int width, PixelNoise noise,
                float memory_frames, const AverageRow& average, const LeanSums& leans) noexcept;

/// Evaluates a spline over `intervals` of 16 pixels. Interval i depends on coefficients i to i + 3. `splines`: the 16
/// values between two knots of each of the four basis functions.
void spline_row(const float* coefficients, int intervals, const float* splines, float* out) noexcept;

}  // namespace telepalp::surface
