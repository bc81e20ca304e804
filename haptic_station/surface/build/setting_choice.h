#pragma once

#include <string>
#include <vector>

#include "haptic_station/surface/snapshot/surface_settings.h"

namespace telepalp::surface {

/// What a scene's setting may fall back to, best first, the scene's own in front: coarser lattices for the grid,
/// quicker indices of the same function for the paper's reference. All of one method, so that who reads the snapshots
/// need not change.
[[nodiscard]] std::vector<SurfaceSettings> affordable_settings(const SurfaceSettings& asked);

/// Picks among them by what they cost on this machine: a snapshot may take half of a frame's time. Too slow for a third
/// of a second: the next one; well within for ten seconds: the better one gets another try, the longer the oftener it
/// failed. Owner: the surface thread.
class SettingChoice {
 public:
  explicit SettingChoice(const SurfaceSettings& asked) : settings_(affordable_settings(asked)) {}

  [[nodiscard]] const SurfaceSettings& now() const noexcept { return settings_[chosen_]; }
  /// One snapshot took `cost_s`, and frames come every `frame_s`. True: now() is another one.
  bool add(double cost_s, double frame_s) noexcept;

 private:
  std::vector<SurfaceSettings> settings_;
  std::size_t chosen_ = 0;
  double over_s_ = 0.0;    ///< time for which snapshots have been too slow
  double within_s_ = 0.0;  ///< and well within
  double retry_after_s_ = 10.0;
};

}  // namespace telepalp::surface
