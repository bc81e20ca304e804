#include "tests/bench/choice.h"
#include "tests/bench/site/section.h"
#include "tests/bench/users/section.h"
#include "where.h"

namespace telepalp::bench {

Result<SiteRows> run_strangers_section(const SitePlace& place) {
  const UsersPlace programs{.programs = place.programs,
                            .viewer = TELEPALP_BINARY_DIR "/viewer",
                            .sources = TELEPALP_SOURCE_DIR,
                            .scratch = place.scratch};
  Result<std::vector<Row>> rows = rows_of_script(programs, programs.sources / "tests/bench/site/strangers_rows.mjs");
  if (!rows) return rows.error();
  SiteRows measured;
  for (Row& row : *rows)
    if (place.wanted.empty() || contains_one_of(row.name, place.wanted)) measured.rows.push_back(std::move(row));
  return measured;
}

}  // namespace telepalp::bench
