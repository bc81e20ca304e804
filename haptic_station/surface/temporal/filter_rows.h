#pragma once

namespace telepalp::surface {

// Functions for one row of pixels of the temporal filter. They use plain arrays, no branch that depends on a pixel, and
// sums by column, so that compilers vectorise them. The results are equal on all processors that round as IEEE 754
// requires. The noise model: 1.2 mm + 1.9 mm/m² (z − 0.4 m)² at the depth z (Nguyen, Izadi and Lovell 2012).

/// Scale of the camera's depth noise.
struct PixelNoise {
  float scale = 1.0F;  ///< ratio of the measured standard deviation to the noise model's
};

/// Sums by column over the rows of a cell of 16 × 16 pixels (CellLattice).
struct ColumnSums {
  float* innovation;  ///< measured minus expected depth [m]
  float* unit;        ///< |innovation| / sigma of the noise model, without PixelNoise::scale
  float* sigma;       ///< sigma of the noise model times PixelNoise::scale, at least 0.2 mm [m]
  float* count;       ///< number of pixels
};

/// Adds the innovations of one row, `seen` − (`average` + `change`) [m], with the predicted change of depth `change`,
/// at the pixels where `seen` and `average` are known (not 0) and the innovation is at most 10 sigma.
void observe_row(const float* seen, const float* average, const float* change, int width, PixelNoise noise,
                 const ColumnSums& sums) noexcept;

/// Share of a pixel's frame count that an unmeasured frame leaves.
inline constexpr float kUnseenKeep = 0.7F;

/// A row's running average.
struct AverageRow {
  float* depth_m;  ///< 0: unknown
  float* frames;   ///< number of frames in the average
};

/// Sums by column over the rows of a patch of 4 × 4 pixels.
struct LeanSums {
  float* lean;   ///< sum of residuals, each scaled to unit variance under noise alone
  float* count;  ///< number of residuals
};

/// Adds `moved`, the cell's filtered change of depth, to the average, then updates the average with `seen` [m]; the
/// average counts at most `memory_frames` frames, and fewer after an outlier (over 5 sigma) or a gap. Adds the
/// residuals, `seen` − (average before + `expected`), to `leans`. `expected` is the cell's unfiltered change of depth,
/// so that a motion of the whole cell causes no residual in its pixels.
void update_row(const float* seen, const float* moved, const float* expected, int width, PixelNoise noise,
                float memory_frames, const AverageRow& average, const LeanSums& leans) noexcept;

/// Evaluates a spline over `intervals` of 16 pixels. Interval i depends on coefficients i to i + 3. `splines`:
/// [function][pixel], the 16 values between two knots of each of the four basis functions.
void spline_row(const float* coefficients, int intervals, const float* splines, float* out) noexcept;

}  // namespace telepalp::surface
