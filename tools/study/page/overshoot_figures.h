#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/plot/chart.h"
#include "support/plot/heat_map.h"
#include "tools/study/figures/statistics.h"

namespace telepalp::study {

// Figures of the needle's study, for simulated operators and for people. A mechanism with which nobody has punctured
// the sac yet has no mean, and is left out.

/// A chart of overshoots [mm] over the number of the mechanism in the table, which has `mechanisms`.
[[nodiscard]] plot::Chart overshoot_chart(std::size_t mechanisms);
/// The 95 % intervals of the mechanisms as lines, and their means as dots under the name `name`.
void add_overshoots(plot::Chart& chart, std::string_view name, std::span<const Interval> mm, std::string_view color);
/// S4's Table 2 as dots.
void add_paper(plot::Chart& chart);
/// Table 2's layout: rows are linkage and phi, columns h and l_h. `mm`: of the 36 mechanisms.
[[nodiscard]] plot::HeatMap table_2_map(const std::string& title, const std::vector<double>& mm);
/// What contact point, direction, stop and overshoot mean: items of an HTML description list.
extern const std::string_view kTaskRules;

}  // namespace telepalp::study
