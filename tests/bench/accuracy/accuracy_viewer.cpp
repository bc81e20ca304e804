#include "tests/bench/accuracy/accuracy_viewer.h"

#include "tests/bench/users/section.h"
#include "where.h"

namespace telepalp::bench {

Result<PageTable> viewer_table(std::vector<Row>& rows) {
  constexpr std::size_t kFigures = 3;  // of each level: triangles, time, error
  const UsersPlace place{.programs = TELEPALP_BINARY_DIR "/bin",
                         .viewer = TELEPALP_BINARY_DIR "/viewer",
                         .sources = TELEPALP_SOURCE_DIR,
                         .scratch = {}};
  const Result<std::vector<Row>> levels =
      rows_of_script(place, TELEPALP_SOURCE_DIR "/tests/bench/viewer/detail_rows.mjs");
  if (!levels) return levels.error();
  PageTable table{.head = {"drawn surface", "triangles", "main thread, ms a picture, p50", "error mm, RMS"},
                  .rows = {}};
  for (std::size_t level = 0; level + kFigures <= levels->size(); level += kFigures) {
    const std::string& name = (*levels)[level].name;
    table.rows.push_back({name.substr(0, name.find(':'))});
    for (std::size_t figure = 0; figure < kFigures; ++figure)
      table.rows.back().push_back(cell((*levels)[level + figure].value));
  }
  rows.insert(rows.end(), levels->begin(), levels->end());
  return table;
}

}  // namespace telepalp::bench
