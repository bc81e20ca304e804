#pragma once

#include <vector>

#include "tests/bench/accuracy/accuracy_page.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// The meshes of the prism: error of the stiffness at the top, and cost of the whole station.
[[nodiscard]] Result<PageTable> prism_meshes_table(std::vector<Row>& rows);
/// The prism's local models at lower and lower rates: error of the force, and cost of the whole station.
[[nodiscard]] Result<PageTable> prism_rates_table(std::vector<Row>& rows);

}  // namespace telepalp::bench
