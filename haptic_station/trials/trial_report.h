#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "haptic_station/trials/trial_run.h"
#include "proto/words/result.h"

namespace telepalp::trials {

/// Each trial's figures, phases and transitions.
[[nodiscard]] std::string to_json(std::span<const TrialResult> results);

/// One page with plots like S1 Fig. 5 to 8: place by phase, and force against indentation.
[[nodiscard]] std::string to_html(std::span<const TrialResult> results);

/// Writes report.json and report.html into `folder`, made if need be.
[[nodiscard]] Result<void> write_report(std::span<const TrialResult> results, const std::filesystem::path& folder);

}  // namespace telepalp::trials
