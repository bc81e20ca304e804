#pragma once

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/temporal/motion_field.h"

namespace telepalp::surface {

/// Averages depth over frames where the patient is still and follows where they move. Each pixel's average is carried
/// along by its cell's motion, so breathing does not smear it; what moves otherwise shows as a patch whose residuals
/// have one sign, and there the average starts anew. Latency: none on modelled motion; on an unmodelled step two to
/// four frames until the patch is noticed; below that (a patch mean under 4.5 sigma/4) the average's own memory.
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
  std::vector<float> moved_at_;     ///< of one row of pixels, padded as spread_over_row() asks
  std::vector<float> expected_at_;  ///< the same
  std::vector<float> sums_;         ///< by column: four or two rows, added up over the rows of a cell or a patch
  std::vector<CellInnovation> seen_;
  std::vector<float> patch_mean_;  ///< running
  float memory_frames_;
  float noise_scale_ = 1.0F;  ///< measured noise over the model's
  double noise_sum_ = 0.0;
  double noise_count_ = 0.0;
  bool first_ = true;
};

/// Single pixels that were not measured, between measured ones that agree, get their mean: what flickers must not cost
/// a window its fast path.
void fill_pinholes(DepthField& depth, double break_at_1m);

}  // namespace telepalp::surface
