#pragma once

#include "tests/bench/accuracy/accuracy_page.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// What the page's levels of detail cost without a graphics card, and how far the drawn surface is off. Runs the page's
/// own code in Node; adds its figures to `rows`. Error: no Node, or no packages of the page in the build.
[[nodiscard]] Result<PageTable> viewer_table(std::vector<Row>& rows);

}  // namespace telepalp::bench
