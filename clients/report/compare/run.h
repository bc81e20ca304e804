#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "clients/report/summary/verdict.h"
#include "proto/wire/mcap/writer.h"
#include "proto/words/result.h"

namespace telepalp::report {

/// What telepalp-replay wrote about a run into report.json beside its session.
struct ReplayFacts {
  std::string network;  ///< network and faults in words; the unimpaired run: "none"
  std::string seed;
  std::string hand;                       ///< "recorded" or "examine"
  std::map<std::string, double> figures;  ///< by metric, see docs/replay.md; unknown ones are missing
};

/// One of the runs that are compared.
struct Run {
  std::string label;  ///< name on the page
  std::filesystem::path file;
  Session session;
  Summary summary;
  Verdict verdict;
  wire::SessionInfo info;
  std::optional<ReplayFacts> replay;  ///< nullopt: not a replay, or its report.json is missing
};

/// Reads a session file, or the file session.mcap in the folder `asked`. Error: see read_session().
[[nodiscard]] Result<Run> read_run(const std::filesystem::path& asked);

/// The facts in `json`, the text of a report.json of telepalp-replay. `unimpaired`: those of the run over the network
/// without faults. nullopt: another file.
[[nodiscard]] std::optional<ReplayFacts> replay_facts(const std::string& json, bool unimpaired);

/// Shortest ends of the two paths that differ, as labels: "lte/session.mcap" and "lan/session.mcap".
void label(Run& a, Run& b);

}  // namespace telepalp::report
