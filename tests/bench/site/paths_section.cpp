#include "tests/bench/choice.h"
#include "tests/bench/site/path_delay.h"
#include "tests/bench/site/section.h"
#include "tests/bench/users/section.h"
#include "where.h"

namespace telepalp::bench {
namespace {

constexpr double kMostAdded_ms = 0.5;

}  // namespace

Result<SiteRows> run_paths_section(const SitePlace& place) {
  const UsersPlace programs{.programs = place.programs,
                            .viewer = TELEPALP_BINARY_DIR "/viewer",
                            .sources = TELEPALP_SOURCE_DIR,
                            .scratch = place.scratch};
  Result<std::vector<Row>> rows = rows_of_script(programs, programs.sources / "tests/bench/site/paths_rows.mjs");
  if (!rows) return rows.error();
  const Result<PathDelay> delay = measure_path_delay();
  if (!delay) return delay.error();
  rows->push_back(measured("paths: a datagram by plain sockets, p99", delay->plain_p99_ms, "ms"));
  rows->push_back(
      at_most("paths: a direct path adds, p99", delay->path_p99_ms - delay->plain_p99_ms, "ms", kMostAdded_ms));
  SiteRows chosen;
  for (Row& row : *rows)
    if (place.wanted.empty() || contains_one_of(row.name, place.wanted)) chosen.rows.push_back(std::move(row));
  return chosen;
}

}  // namespace telepalp::bench
