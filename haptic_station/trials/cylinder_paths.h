#pragma once

#include "haptic_station/trials/trial_run.h"
#include "support/plot/chart.h"

namespace telepalp::trials {

/// S1 Fig. 7: the end-effector's path seen from the side while it presses an inner object's upper and lateral area,
/// with the force as lines of 2 mm a newton. No series where no object is pressed.
[[nodiscard]] plot::Chart cylinder_paths(const TrialResult& result);

}  // namespace telepalp::trials
