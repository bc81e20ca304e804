#include "tests/bench/site/site_bench.h"

#include <cstdio>

#include "tests/bench/choice.h"
#include "tests/bench/site/section.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::bench {
namespace {

/// All sections. A new one needs a file <name>_section.cpp, a declaration in section.h and a row here.
const std::vector<SiteSection> kSections{
    {"flows", "a session of touch beside other flows, through the kernel's queue", run_flows_section},
    {"meet", "a thousand sites at one meeting point, and its restart", run_meeting_section},
    {"paths", "ways of datagrams between sites behind routers of seven kinds", run_paths_section},
    {"strangers", "silent and flooding strangers, revoked keys, and the audit log", run_strangers_section},
};

}  // namespace

Result<Report> run_site(const program::Arguments& arguments) {
  const Result<std::vector<SiteSection>> sections = chosen_sections(kSections, arguments, "site");
  if (!sections) return sections.error();
  const std::string wanted = arguments.has("row") ? arguments.text("row") : "";
  Report report{.bench = "site", .rows = {}, .notes = {}};
  for (const SiteSection& section : *sections) {
    const support::TemporaryFolder scratch;
    Result<SiteRows> measured =
        section.run({.programs = TELEPALP_BINARY_DIR "/bin", .scratch = scratch.path(), .wanted = wanted});
    if (!measured) return measured.error();
    for (Row& row : measured->rows) report.rows.push_back(std::move(row));
    for (const std::string& words : measured->skipped) {
      std::fprintf(stderr, "telepalp-bench site: skipped: %s\n", words.c_str());
      report.notes.push_back("skipped: " + words);
    }
  }
  if (report.rows.empty() && report.notes.empty())
    return Error{.what = "no run's name contains '" + wanted + "'",
                 .where = "telepalp-bench site --row",
                 .fix =
                     "give parts of names such as cubic, bbr, reno, pages, upload, 'two sessions', '40 Mbit/s', with "
                     "commas between"};
  return report;
}

}  // namespace telepalp::bench
