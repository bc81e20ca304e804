#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Where a section of `telepalp-bench site` finds the programs, where it may write, and what it runs.
struct SitePlace {
  std::filesystem::path programs;  ///< the folder with telepalp-server and the other programs of this build
  std::filesystem::path scratch;   ///< an empty folder, removed after the section
  std::string_view wanted;         ///< --row: parts of runs' names (contains_one_of()); empty: all runs
};

/// Figures of one section, and what the kernel lacks for it.
struct SiteRows {
  std::vector<Row> rows;
  std::vector<std::string> skipped;  ///< one sentence for each group of rows for which the kernel lacks something
};

/// One group of rows of two sites and the network between them; `--part NAME` runs it alone.
struct SiteSection {
  std::string_view name;
  std::string_view purpose;
  Result<SiteRows> (*run)(const SitePlace& place);
};

/// A session of touch beside other flows, through the kernel's own queue.
[[nodiscard]] Result<SiteRows> run_flows_section(const SitePlace& place);

/// A thousand sites at one meeting point, and its restart.
[[nodiscard]] Result<SiteRows> run_meeting_section(const SitePlace& place);

/// The ways of datagrams between two sites behind routers of seven kinds, a change of the network, and what a direct
/// path adds to the delay.
[[nodiscard]] Result<SiteRows> run_paths_section(const SitePlace& place);

/// A real server on loopback: connections that send nothing and keep others out, revoked keys, and the audit log's
/// lines about streams and revoked keys.
[[nodiscard]] Result<SiteRows> run_strangers_section(const SitePlace& place);

}  // namespace telepalp::bench
