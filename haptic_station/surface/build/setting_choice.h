#pragma once

#include <string>
#include <vector>

#include "haptic_station/surface/snapshot/surface_settings.h"

namespace telepalp::surface {

/// The setting `asked`, followed by cheaper ones, best first: coarser lattices for Method::Grid, a faster index with
/// the same result for Method::Paper, none for Method::Cloud. All have the method of `asked`, so no other threads are
/// needed to read their snapshots.
[[nodiscard]] std::vector<SurfaceSettings> affordable_settings(const SurfaceSettings& asked);

/// Selects among affordable_settings() by the measured cost of a snapshot, which may take half of the frame period.
/// When the frames above this limit have lasted 1/3 s longer than those below it, the next cheaper setting is selected.
/// The next better setting is retried after a run of snapshots that take less than 15 % of the frame period. This run
/// lasts 10 s after the first selection of a cheaper setting. Each further selection of a cheaper setting doubles this
/// time, up to 600 s. Owner: surface thread.
class SettingChoice {
 public:
  explicit SettingChoice(const SurfaceSettings& asked) : settings_(affordable_settings(asked)) {}

  [[nodiscard]] const SurfaceSettings& now() const noexcept { return settings_[chosen_]; }
  /// Adds the cost of a snapshot, `cost_s`, at a frame period of `frame_s`. Returns true when now() has changed.
  bool add(double cost_s, double frame_s) noexcept;

 private:
  std::vector<SurfaceSettings> settings_;
  std::size_t chosen_ = 0;
  double over_s_ = 0.0;         ///< time of too slow snapshots minus that of others, at least 0
  double within_s_ = 0.0;       ///< duration of the current run of snapshots below 15 % of the frame period
  double retry_after_s_ = 0.0;  ///< 0: no cheaper setting was selected yet
};

}  // namespace telepalp::surface
