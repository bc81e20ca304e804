#include "tests/bench/users/users_bench.h"

#include "tests/bench/choice.h"
#include "tests/bench/users/sections.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::bench {
namespace {

/// All sections. A new one needs a file <name>_section.cpp, a declaration in sections.h and a row here.
const std::vector<UsersSection> kSections{
    {"gate", "twelve planted defects against a gate", run_gate_section},
    {"bill", "what a scene costs, by its bill and as measured at the station's process", run_bill_section},
    {"journal", "a station's journal, computed again to the last bit", run_journal_section},
    {"page", "a server that is silent, and a played session that is moved image by image", run_page_section},
    {"layout", "the patient's share of the page", run_layout_section},
    {"records", "damaged sessions, and whether verify and repair say so", run_records_section},
    {"solids", "meshes of twenty solids that are known from geometry", run_solids_section},
    {"tool", "a device that measures six degrees of freedom and drives three", run_tool_section},
    {"hover", "a pointer without a button never pushes the device into the body", run_hover_section},
};

}  // namespace

Result<Report> run_users(const program::Arguments& arguments) {
  const Result<std::vector<UsersSection>> sections = chosen_sections(kSections, arguments, "users");
  if (!sections) return sections.error();
  Report report{.bench = "users", .rows = {}, .notes = {}};
  for (const UsersSection& section : *sections) {
    std::fprintf(stderr, "telepalp-bench users: %.*s: %.*s\n", static_cast<int>(section.name.size()),
                 section.name.data(), static_cast<int>(section.purpose.size()), section.purpose.data());
    const support::TemporaryFolder scratch;
    Result<std::vector<Row>> rows = section.run({.programs = TELEPALP_BINARY_DIR "/bin",
                                                 .viewer = TELEPALP_BINARY_DIR "/viewer",
                                                 .sources = TELEPALP_SOURCE_DIR,
                                                 .scratch = scratch.path()});
    if (!rows) return rows.error();
    for (Row& row : *rows) report.rows.push_back(std::move(row));
  }
  return report;
}

}  // namespace telepalp::bench
