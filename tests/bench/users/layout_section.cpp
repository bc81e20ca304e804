#include "tests/bench/users/sections.h"

namespace telepalp::bench {

Result<std::vector<Row>> run_layout_section(const UsersPlace& place) {
  return rows_of_script(place, place.sources / "tests/bench/users/layout.mjs");
}

}  // namespace telepalp::bench
