#pragma once

#include <string>

#include "tools/edge_plan/edge_plan.h"

namespace telepalp::edge_plan {

/// A plan for a person, at most ten lines; the last one says what limits the class, and what would help.
[[nodiscard]] std::string in_lines(const Asked& asked, const EdgeCosts& edge, const EdgePlan& plan);

}  // namespace telepalp::edge_plan
