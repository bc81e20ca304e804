#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "support/plot/bars.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// Histograms of the duration and the lateness of ticks, with the period of 500 µs marked. Both axes are logarithmic,
/// so that one slow tick in ten thousand is visible.
[[nodiscard]] std::vector<plot::Chart> tick_times(const Session& session);

/// Latency of a frame from camera to hand, by stage: p50 and p99.
[[nodiscard]] plot::BarChart latency_by_stage(const Summary& summary);

/// Age over time of the surface from which the force was computed.
[[nodiscard]] plot::Chart surface_age(const Session& session);

/// Recorded depth and colour frames per second over time.
[[nodiscard]] plot::Chart frame_rate(const Session& session);

}  // namespace telepalp::report
