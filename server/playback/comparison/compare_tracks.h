#pragma once

#include "messages/playback.pb.h"
#include "server/playback/comparison/state_track.h"

namespace telepalp::playback {

/// Number of bins of the time axis: about one for each pixel of a plot's width.
inline constexpr int kComparisonBins = 1000;

/// A difference of force that a hand can notice in a small contact force: a tenth of 0.5 N, as in telepalp-report.
inline constexpr double kFeltDifference_N = 0.05;

/// Puts two runs on one time axis. Runs whose session times overlap are compared at equal session times; other runs are
/// aligned at their first states, as in `telepalp-report A B`. Forces are compared at the states of `a` that have a
/// state of `b` within 10 ms, if at least one of the two is in contact. Precondition: both tracks have points.
[[nodiscard]] msg::ComparisonState compare_tracks(const StateTrack& a, const StateTrack& b);

}  // namespace telepalp::playback
