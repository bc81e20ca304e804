#include "haptic_station/surface/temporal/filter_rows.h"

#include <algorithm>
#include <cmath>

#include "proto/words/vectorised.h"

// These loops take most of the time of a frame, so they are also compiled for AVX2, and the processor found at run time
// selects the version. This file must not use inline functions of headers that other files compile for another
// instruction set.

namespace telepalp::surface {
namespace {

constexpr float kFloor_m = 2e-4F;  // least standard deviation of the noise: rounding
constexpr float kOutlier = 5.0F;   // a pixel farther than this from its average is an outlier [sigma]
constexpr float kOutlierKeep = 0.2F;
constexpr float kLeastFrames = 0.5F;  // an unmeasured pixel with a lower frame count is discarded

}  // namespace

TELEPALP_VECTORISED
void observe_row(const float* __restrict seen, const float* __restrict average, const float* __restrict change,
                 int width, PixelNoise noise, const ColumnSums& sums) noexcept {
  float* __restrict innovation = sums.innovation;
  float* __restrict unit = sums.unit;
  float* __restrict sigmas = sums.sigma;
  float* __restrict count = sums.count;
  for (int u = 0; u < width; ++u) {
    const float z = seen[u];
    const float expected = average[u] + change[u];
    const float r = z - expected;
    // Axial noise of a structured-light camera [m], as in node_fit.
    const float model = 0.0012F + 0.0019F * (expected - 0.4F) * (expected - 0.4F);
    const float scaled = model * noise.scale;
    const float sigma = scaled > kFloor_m ? scaled : kFloor_m;
    const float size = r < 0.0F ? -r : r;
    const float use = (z > 0.0F) & (average[u] > 0.0F) & (size <= 2.0F * kOutlier * sigma) ? 1.0F : 0.0F;
    innovation[u] += use * r;
    unit[u] += use * (size / model);
    sigmas[u] += use * sigma;
    count[u] += use;
  }
}

TELEPALP_VECTORISED
void update_row(const float* __restrict seen, const float* __restrict moved, const float* __restrict expected,
                int width, PixelNoise noise, float memory_frames, const AverageRow& average,
                const LeanSums& leans) noexcept {
  float* __restrict depth_m = average.depth_m;
  float* __restrict frames = average.frames;
  float* __restrict lean = leans.lean;
  float* __restrict count = leans.count;
  for (int u = 0; u < width; ++u) {
    const float z = seen[u];
    const float old = depth_m[u];
    const float n = frames[u];
    const float carried = old + moved[u];
    const float r = z - (old + expected[u]);
    const float scaled = (0.0012F + 0.0019F * (carried - 0.4F) * (carried - 0.4F)) * noise.scale;
    const float sigma = scaled > kFloor_m ? scaled : kFloor_m;
    const bool known = old > 0.0F;
    const bool measured = z > 0.0F;
    const bool outlier = (r < 0.0F ? -r : r) > kOutlier * sigma;

    // One conditional per line: GCC 12 does not vectorise nested conditionals.
    const float next = n + 1.0F;
    const float more = next < memory_frames ? next : memory_frames;
    const float keep = measured ? kOutlierKeep : kUnseenKeep;
    const float least = measured ? 1.0F : kLeastFrames;
    const float one = measured ? 1.0F : 0.0F;
    const float fewer = n * keep;
    const bool anew = fewer < least;
    const float share = 1.0F / more;
    const float averaged = carried + r * share;
    const float doubted = anew ? z : carried;  // if the pixel is not measured, z is 0
    const float doubted_frames = anew ? one : fewer;
    const bool good = measured & !outlier;
    const float tracked = good ? averaged : doubted;
    const float tracked_frames = good ? more : doubted_frames;
    depth_m[u] = known ? tracked : z;
    frames[u] = known ? tracked_frames : one;
    const float use = (known & good) ? 1.0F : 0.0F;
    lean[u] += use * (r / (sigma * std::sqrt(1.0F + 2.0F * share)));  // the average has an error, too
    count[u] += use;
  }
}

TELEPALP_VECTORISED
void spline_row(const float* coefficients, int intervals, const float* __restrict splines, float* out) noexcept {
  for (int interval = 0; interval < intervals; ++interval) {
    const float* __restrict c = coefficients + interval;
    float* __restrict values = out + 16 * interval;
    for (int pixel = 0; pixel < 16; ++pixel)
      values[pixel] =
          c[0] * splines[pixel] + c[1] * splines[16 + pixel] + c[2] * splines[32 + pixel] + c[3] * splines[48 + pixel];
  }
}

}  // namespace telepalp::surface
