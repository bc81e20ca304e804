#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// Fig. 5 of S1 for this run: the end-effector against the tracked hand, vertical, by state.
[[nodiscard]] plot::Chart position_by_state(const Session& session);

/// Fig. 6: force against indentation along x, y and z of the haptic base, and their norms. The indentation of an axis
/// is counted from the proxy at first contact (S1 eq. 8).
[[nodiscard]] std::vector<plot::Chart> force_against_indentation(const Session& session);

/// Fig. 7: paths from the side and from above, and force, in the states of the cylinder. Empty when none was visited.
[[nodiscard]] std::vector<plot::Chart> around_the_cylinder(const Session& session);

/// Fig. 8: state, position and force over time, three charts with one time axis.
[[nodiscard]] std::vector<plot::Chart> timeline(const Session& session);

}  // namespace telepalp::report
