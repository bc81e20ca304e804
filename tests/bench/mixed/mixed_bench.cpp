#include "tests/bench/mixed/mixed_bench.h"

#include <cstdio>

#include "tests/bench/choice.h"
#include "tests/bench/mixed/section.h"

namespace telepalp::bench {
namespace {

const std::vector<MixedSection> kSections{
    {"calibration", "where the device stands, by clicks", run_calibration_section},
    {"labels", "masks of device and hand", run_labels_section},
    {"background", "the completed background", run_background_section},
    {"hand", "the hand at the tool, and the time of an image", run_hand_section},
    {"anchor", "a headset anchored by touches; thresholds of ideal observers", run_anchor_section},
};

}  // namespace

Result<Report> run_mixed(const program::Arguments& arguments) {
  const Result<std::vector<MixedSection>> sections = chosen_sections(kSections, arguments, "mixed");
  if (!sections) return sections.error();
  Report report{.bench = "mixed", .rows = {}, .notes = {}};
  for (const MixedSection& section : *sections) {
    std::fprintf(stderr, "telepalp-bench mixed: %.*s: %.*s\n", static_cast<int>(section.name.size()),
                 section.name.data(), static_cast<int>(section.purpose.size()), section.purpose.data());
    for (Row& row : section.run()) report.rows.push_back(std::move(row));
  }
  report.notes.push_back("rendered desk with matt surfaces and no sensor noise; hands and device have no shadow");
  return report;
}

}  // namespace telepalp::bench
