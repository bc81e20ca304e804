#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptic_station/surface/depth/block_depths.h"
#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/temporal/motion_field.h"

namespace telepalp::surface {

/// Averages the depth of each pixel over frames. The average moves with the pixel's cell in MotionField, so that
/// breathing does not smear it. Any other motion gives a patch of 4 × 4 pixels residuals of one sign; the average of
/// that patch then counts as at most four frames. Latency: none for motion that MotionField models. A step in depth
/// that MotionField does not model is detected after two to four frames. The error of a step too small to detect (below
/// about 0.65 sigma of a pixel's noise) fades as newer frames enter the average.
class TemporalFilter {
 public:
  TemporalFilter(int width, int height, const SurfaceSettings& settings);

  /// Returns the averaged depth at the time of the frame `seen`, `dt_s` after the last one; valid until the next call.
  /// The first frame is returned unchanged. `hidden`: 1 for each block of 4 × 4 pixels over which an object lies, row
  /// by row; empty: there is none. `seen` must not measure their pixels. Their averages move with the body, and do not
  /// age.
  [[nodiscard]] const DepthField& add(const DepthField& seen, double dt_s, std::span<const std::uint8_t> hidden = {});
  [[nodiscard]] const MotionField& motion() const noexcept { return motion_; }

 private:
  void observe(const DepthField& seen);
  void update(const DepthField& seen);
  void end_of_cells(int cell_row);
  void end_of_patches(int patch_row);
  void find_hidden_cells(std::span<const std::uint8_t> hidden);
  void keep_hidden(std::span<const std::uint8_t> hidden);

  static constexpr int kPatch_px = BlockLattice::kBlock_px;

  DepthField average_;
  MotionField motion_;
  std::vector<float>
      moved_at_;  ///< scratch, one row of pixels [m]: change of depth, as MotionField predicts or estimates it
  std::vector<float> expected_at_;  ///< scratch, the same row [m]: change of depth with the whole innovation
  std::vector<float> sums_;  ///< scratch: sums over the rows of a cell or of a patch, for each column (filter_rows.h)
  std::vector<CellInnovation> seen_;
  std::vector<std::uint8_t> hidden_cells_;  ///< 1: an object hides most of the cell; empty: none
  std::vector<float> patch_mean_;           ///< running mean of the residuals of each patch
  float memory_frames_;
  float noise_scale_ = 1.0F;  ///< ratio of the measured noise to the noise model
  double noise_sum_ = 0.0;
  double noise_count_ = 0.0;
  bool first_ = true;
};

/// Fills each unmeasured pixel whose four neighbours are measured, without a depth break between them, with the
/// harmonic mean of their depths. Without this, flickering pixels would force fit_nodes() to use its slow path, the fit
/// of a window with holes. `break_at_1m`: see break_at() in depth_field.h.
void fill_pinholes(DepthField& depth, double break_at_1m);

}  // namespace telepalp::surface
