#pragma once

#include <map>
#include <string>

#include "support/program/json.h"
#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Every setting on which a run's result depends beside its source, scene and hand, as texts by name:
/// "surface_setting", "depth_coding", "network_down", "clock_step", … A fault that does not occur is "none".
[[nodiscard]] std::map<std::string, std::string> settings_of(const Request& request, const Scenario& scenario);

/// Adds the object "settings", and the object "again" from which the source again:DIR repeats the run. `scenario`: of
/// this run. `options`: of the command line that makes this run (Request::options, or those of a sweep's cell).
/// `images`: that the run read.
void add_settings(program::Json& json, const Request& request, const Scenario& scenario, const RunOptions& options,
                  const ImageFacts& images);

/// The digest of all that a run's result depends on: program, source, scene, recorded hand, settings. Equal identities
/// give equal results.
[[nodiscard]] std::string identity_of(const Request& request, const Scenario& scenario);

}  // namespace telepalp::replay
