#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "support/plot/bars.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// How long ticks took and how late they began, against the period of 500 µs. Counts and times on logarithmic axes:
/// what matters is the one tick in ten thousand.
[[nodiscard]] std::vector<plot::Chart> tick_times(const Session& session);

/// A frame's way from the camera to the hand by stage, p50 and p99.
[[nodiscard]] plot::BarChart latency_by_stage(const Summary& summary);

/// Age of the surface that the force came from, over time.
[[nodiscard]] plot::Chart surface_age(const Session& session);

/// Depth and colour frames captured, a second, over time; only what was recorded.
[[nodiscard]] plot::Chart frame_rate(const Session& session);

}  // namespace telepalp::report
