#pragma once

#include "messages/playback.pb.h"
#include "server/playback/comparison/state_track.h"

namespace telepalp::playback {

/// Number of bins of the time axis: about one for each pixel of a plot.
inline constexpr int kComparisonBins = 1000;

/// A difference of force that a hand can notice in a small contact force: a tenth of 0.5 N, as in telepalp-report.
inline constexpr double kFeltDifference_N = 0.05;

/// Puts two runs on one time axis. Runs that share session time are compared at equal times, others from their first
/// states on, as by `telepalp-report A B`, which compares the ticks at 2 kHz. Forces are compared at the states of `a`
/// that have a state of `b` within 10 ms, if at least one of these states is in contact. Both tracks have points.
[[nodiscard]] msg::ComparisonState compare_tracks(const StateTrack& a, const StateTrack& b);

}  // namespace telepalp::playback
