#pragma once

#include "proto/words/result.h"
#include "tools/replay/run/live_run.h"

namespace telepalp::bench {

/// The same replay over a network in virtual time and over real UDP sockets, through telepalp-link's proxy in this
/// process, in real time.
struct LiveComparison {
  replay::Figures in_virtual_time;
  replay::Figures live;
  double latest_s = 0.0;  ///< how late the latest tick of the live run began; a slow machine is late
  bool realtime = false;  ///< the live run had real-time priority
};
[[nodiscard]] Result<LiveComparison> compare_live(const std::string& source, const scenes::Scene& scene,
                                                  const replay::Scenario& scenario, double seconds);

}  // namespace telepalp::bench
