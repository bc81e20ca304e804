#include "tests/bench/accuracy/accuracy_bench.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "support/program/version.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/choice.h"

namespace telepalp::bench {
namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

struct Part {
  std::string_view name;
  Result<Section> (*measure)();
};
const std::vector<Part> kParts{
    {"surface", surface_section},       {"slopes", slopes_section}, {"patients", patients_section},
    {"prediction", prediction_section}, {"organ", organ_section},   {"solids", solids_section},
    {"needle", needle_section},         {"price", price_section},   {"settings", settings_section},
    {"z-width", z_width_section},       {"depth", depth_section},   {"thin", thin_section}};

}  // namespace

Result<Report> run_accuracy(const program::Arguments& arguments) {
  const Result<std::vector<Part>> parts = chosen_sections(kParts, arguments, "accuracy");
  if (!parts) return parts.error();
  Section all;
  for (const Part& part : *parts) {
    Result<Section> section = part.measure();
    if (!section) return section.error();
    append(all.rows, std::move(section->rows));
    append(all.parts, std::move(section->parts));
    all.parts.push_back({"measured-" + std::string(part.name),
                         "*Measured on " + machine_name() + ", at commit " + program::commit() + ".*\n"});
    append(all.pictures, std::move(section->pictures));
  }
  Report report{.bench = "accuracy", .rows = std::move(all.rows), .notes = {}};
  report.notes = {
      "shapes: the worst of six that a formula defines, radii >= 50 mm, points 1.5 mm apart at 0.8 m, no noise",
      "torso: 640x480, Gaussian noise of 1 mm, still, after one second of frames; surface built within 0.16 m of the "
      "hand, as by the station",
      "load: share of one core for 30 snapshots and 2000 steps a second, computed from the medians"};
  if (arguments.has("write")) {
    const std::filesystem::path page = std::filesystem::path(arguments.text("write")) / "accuracy.md";
    if (const auto done = rewrite_page(page, all.parts, all.pictures); !done) return done.error();
    report.notes.push_back("written: " + page.string() + " and its plots");
  }
  return report;
}

}  // namespace telepalp::bench
