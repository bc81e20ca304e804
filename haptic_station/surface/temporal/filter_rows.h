#pragma once

namespace telepalp::surface {

// One row of pixels of the temporal filter. Plain arrays, no branch that depends on a pixel, and sums kept by column,
// so that compilers vectorise them: the same results on any processor that rounds each step as IEEE 754 says.

/// What is known of the pixels' noise.
struct PixelNoise {
  float scale = 1.0F;  ///< measured noise over the model's
};

/// Sums by column over the rows of a cell.
struct ColumnSums {
  float* innovation;  ///< measured minus expected [m]
  float* unit;        ///< its size over the noise model's sigma
  float* sigma;       ///< the sigma used [m]
  float* count;
};

/// Adds the innovations of one row: `seen` minus `average` + `change`, where both are known and no outlier.
void observe_row(const float* seen, const float* average, const float* change, int width, PixelNoise noise,
                 const ColumnSums& sums) noexcept;

/// A row's running average.
struct AverageRow {
  float* depth_m;  ///< 0: not known
  float* frames;   ///< that stand behind it
};

/// Sums by column over the rows of a patch.
struct LeanSums {
  float* lean;   ///< of residuals, each of unit variance by chance
  float* count;  ///< of them
};

/// Carries the average along by `moved` and takes in `seen`. Residuals are against `expected`, the cells' whole
/// innovation included: what cells follow is not the pixels' to average.
void update_row(const float* seen, const float* moved, const float* expected, int width, PixelNoise noise,
                float memory_frames, const AverageRow& average, const LeanSums& leans) noexcept;

/// A spline over `intervals` of 16 pixels: interval i is made of coefficients i to i + 3. `splines`: of each of the
/// four, its 16 values between two knots.
void spline_row(const float* coefficients, int intervals, const float* splines, float* out) noexcept;

}  // namespace telepalp::surface
