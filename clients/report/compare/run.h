#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "clients/report/summary/verdict.h"
#include "proto/wire/mcap/writer.h"
#include "proto/words/result.h"

namespace telepalp::report {

/// What telepalp-replay wrote about a run into report.json beside its session.
struct ReplayFacts {
  std::string network;  ///< network and faults in words; "unimpaired (…)": no delay, loss or fault
  std::string seed;
  std::string hand;                               ///< "recorded", or the script: "examine", "tap", "search"
  std::map<std::string, std::string> settings{};  ///< all settings of the replay, by name: "depth_mode" is "fast"
  double depth_bound_mm = kUnknown;  ///< how far the replay's depth coding may move a depth 1 m from the camera
  std::vector<double> camera_px{};   ///< depth camera: focal lengths in x and y, principal point; empty: not stated
  double mean_depth_m = kUnknown;    ///< over all measured pixels of the images that the replay read
  std::map<std::string, double> figures;  ///< by metric (docs/replay.md); metrics without a value are missing
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

  /// How far the depth coding may move a depth 1 m from the camera [mm]; 0: lossless. NaN (kUnknown) if it is not
  /// stated.
  [[nodiscard]] double depth_bound_mm() const noexcept;
  /// The depth camera's focal lengths in x and y and its principal point in x and y [px]; empty: not stated.
  [[nodiscard]] std::vector<double> camera_px() const;
};

/// Reads a session file, or the file session.mcap in the folder `asked`. Error: not a session, or an empty or
/// truncated one.
[[nodiscard]] Result<Run> read_run(const std::filesystem::path& asked);

/// The facts in `json`, the text of telepalp-replay's report.json: about its run or, if `unimpaired` is true, about its
/// reference run over a network without delay, loss and faults. nullopt: `json` is not from telepalp-replay.
[[nodiscard]] std::optional<ReplayFacts> replay_facts(const std::string& json, bool unimpaired);

/// Labels both runs with the shortest tails of their paths that differ: "lte/session.mcap" and "lan/session.mcap".
void label(Run& a, Run& b);

}  // namespace telepalp::report
