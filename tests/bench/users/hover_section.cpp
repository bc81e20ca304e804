#include "tests/bench/users/hover_rows.h"
#include "tests/bench/users/sections.h"

namespace telepalp::bench {

Result<std::vector<Row>> run_hover_section(const UsersPlace& place) {
  Result<std::vector<Row>> rows = hover_rows();
  if (!rows) return rows;
  const Result<std::vector<Row>> driven = rows_of_script(place, place.sources / "tests/bench/users/hover.mjs");
  if (!driven) return driven.error();
  rows->insert(rows->end(), driven->begin(), driven->end());
  return rows;
}

}  // namespace telepalp::bench
