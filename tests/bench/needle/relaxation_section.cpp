#include <cmath>
#include <cstdio>
#include <string>

#include "tests/bench/needle/section.h"
#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::bench {
namespace {

/// Mean share of the force that is left after a time at rest, of needles that were put 85 mm into human livers ex vivo
/// at 5 mm/s (39 insertions of de Jong and Dankelman 2017, docs/sources.md).
struct Rest {
  double seconds;
  double left;
};
constexpr Rest kMeasured[]{{0.1, 0.88}, {0.5, 0.74}, {1.0, 0.68}, {5.0, 0.55}, {20.0, 0.36}};

}  // namespace

/// The liver of `biopsy-two-layers`: the needle goes in at 5 mm/s, to 70 mm, and rests.
std::vector<Row> run_needle_relaxation_section() {
  const scenes::Scene scene = library_scene("biopsy-two-layers");
  tissue::Insertion run(tissue_of(scene));
  run.move({0.0, -0.07, 0.0}, 0.005);
  const double first_N = run.force_N.y();
  double rested_s = 0.0;
  std::vector<Row> rows;
  for (const Rest& rest : kMeasured) {
    run.rest(rest.seconds - rested_s);
    rested_s = rest.seconds;
    char name[120];
    std::snprintf(name, sizeof name, "a needle rests in the liver for %g s: share of the force less that measured",
                  rest.seconds);
    rows.push_back(at_most(name, std::abs(run.force_N.y() / first_N - rest.left), "N/N", 0.08));
  }
  rows.push_back(measured("force of the needle in the liver before it rests", first_N, "N"));
  return rows;
}

}  // namespace telepalp::bench
