#pragma once

#include <vector>

#include "clients/report/session/session.h"
#include "support/plot/chart.h"

namespace telepalp::report {

/// Like Fig. 5 of paper S1 (docs/sources.md): heights of end-effector and tracked hand over time, with the states.
[[nodiscard]] plot::Chart position_by_state(const Session& session);

/// The contacts, as grey bands over a time axis.
[[nodiscard]] std::vector<plot::Band> contact_bands(const Session& session);

/// Like S1 Fig. 6: force against indentation along x, y and z of the haptic base, and their norms. The indentation is
/// measured from the proxy at first contact (S1 eq. 8).
[[nodiscard]] std::vector<plot::Chart> force_against_indentation(const Session& session);

/// Like S1 Fig. 7: paths of the end-effector from the side and from above, and force, in the states around and on the
/// cylinder, S1's object in the body. Empty when the run has no such state.
[[nodiscard]] std::vector<plot::Chart> around_the_cylinder(const Session& session);

/// Like S1 Fig. 8: state, position and force over time, as three charts with one time axis.
[[nodiscard]] std::vector<plot::Chart> timeline(const Session& session);

}  // namespace telepalp::report
