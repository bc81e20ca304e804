#pragma once

#include <string>
#include <vector>

#include "haptic_station/surface/snapshot/surface_settings.h"

namespace telepalp::surface {

/// The scene's setting followed by its cheaper replacements, best first: coarser lattices for the grid, faster indices
/// with the same result for the paper's reference. All use the scene's method, so the thread that reads the snapshots
/// is unaffected.
[[nodiscard]] std::vector<SurfaceSettings> affordable_settings(const SurfaceSettings& asked);

/// Selects among these settings by their measured cost; a snapshot may take half of the frame period. After 1/3 s of
/// slower snapshots it selects the next cheaper setting. After 10 s of snapshots well below the limit it retries the
/// better one; this time grows (back-off) with each failed retry. Owner: surface thread.
class SettingChoice {
 public:
  explicit SettingChoice(const SurfaceSettings& asked) : settings_(affordable_settings(asked)) {}

  [[nodiscard]] const SurfaceSettings& now() const noexcept { return settings_[chosen_]; }
  /// Adds a snapshot that took `cost_s` at a frame period of `frame_s`. Returns true when now() has changed.
  bool add(double cost_s, double frame_s) noexcept;

 private:
  std::vector<SurfaceSettings> settings_;
  std::size_t chosen_ = 0;
  double over_s_ = 0.0;    ///< duration of the current run of too slow snapshots
  double within_s_ = 0.0;  ///< duration of the current run of fast snapshots
  double retry_after_s_ = 10.0;
};

}  // namespace telepalp::surface
