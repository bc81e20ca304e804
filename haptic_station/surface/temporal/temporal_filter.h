#pragma once

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/temporal/motion_field.h"

namespace telepalp::surface {

/// Averages depth over frames where the patient is still and follows the patient where they move. Each pixel's average
/// moves with its cell, so that breathing does not smear it. Any other motion gives a patch of pixels residuals of one
/// sign; there the average starts anew. Latency: none on modelled motion. An unmodelled step is detected after two to
/// four frames. A step too small to detect (patch mean under 4.5 sigma/4) fades with the memory of the average.
class TemporalFilter {
 public:
  TemporalFilter(int width, int height, const SurfaceSettings& settings);

  /// Depth as of this frame, `dt_s` after the last; the first frame passes through.
  [[nodiscard]] const DepthField& add(const DepthField& seen, double dt_s);
  [[nodiscard]] const MotionField& motion() const noexcept { return motion_; }

 private:
  void observe(const DepthField& seen);
  void update(const DepthField& seen);
  void end_of_cells(int cell_row);
  void end_of_patches(int patch_row);

  static constexpr int kPatch_px = 4;

  DepthField average_;
  MotionField motion_;
  std::vector<float> moved_at_;     ///< MotionField::moved() at one row of pixels, padded as spread_over_row() needs
  std::vector<float> expected_at_;  ///< MotionField::expected() at that row
  std::vector<float> sums_;         ///< four or two rows of sums by column, over the rows of a cell or a patch
  std::vector<CellInnovation> seen_;
  std::vector<float> patch_mean_;  ///< running mean of the residuals of each patch
  float memory_frames_;
  float noise_scale_ = 1.0F;  ///< ratio of the measured noise to the noise model
  double noise_sum_ = 0.0;
  double noise_count_ = 0.0;
  bool first_ = true;
};

/// Fills a single unmeasured pixel with the mean of its measured neighbours if these agree. Otherwise flickering pixels
/// would force the plane fit of their window onto its slow path.
void fill_pinholes(DepthField& depth, double break_at_1m);

}  // namespace telepalp::surface
