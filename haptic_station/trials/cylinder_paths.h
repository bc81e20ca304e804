#pragma once

#include "haptic_station/trials/trial_run.h"
#include "support/plot/chart.h"

namespace telepalp::trials {

/// Fig. 7 of paper S1 (docs/sources.md): the end-effector's path seen from the side (x, y) in the phases ObjectUpper
/// and ObjectLateral, with the force as lines of 2 mm per newton. The chart has no series without these phases.
[[nodiscard]] plot::Chart cylinder_paths(const TrialResult& result);

}  // namespace telepalp::trials
