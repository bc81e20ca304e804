#include "tests/bench/users/sections.h"

namespace telepalp::bench {

Result<std::vector<Row>> run_page_section(const UsersPlace& place) {
  return rows_of_script(place, place.sources / "tests/bench/users/page_rows.mjs");
}

}  // namespace telepalp::bench
