#pragma once

#include "tests/bench/users/section.h"

namespace telepalp::bench {

/// What a page says of a server that is silent, and of a played session that is moved image by image, in Chromium.
[[nodiscard]] Result<std::vector<Row>> run_page_section(const UsersPlace& place);

}  // namespace telepalp::bench
