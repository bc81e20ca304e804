#pragma once

#include <string_view>
#include <vector>

#include "clients/report/compare/tick_comparison.h"
#include "support/plot/chart.h"
#include "support/plot/palette.h"

namespace telepalp::report {

inline constexpr std::string_view kColorOfA = plot::kBlue;
inline constexpr std::string_view kColorOfB = plot::kVermilion;

/// State, force, height of the end-effector and force difference of both runs over time. Empty if neither has ticks.
[[nodiscard]] std::vector<plot::Chart> overlaid(const Session& a, const Session& b, const TickComparison& comparison);

/// Force and state of both runs from half a second before to half a second after `instant`.
[[nodiscard]] std::vector<plot::Chart> around(const Session& a, const Session& b, const Instant& instant);

/// Age over time of the surface under the hand in both runs. Empty if neither run has /station/state messages.
[[nodiscard]] std::vector<plot::Chart> overlaid_ages(const Session& a, const Session& b);

}  // namespace telepalp::report
