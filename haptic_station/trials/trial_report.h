#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "haptic_station/trials/trial_run.h"
#include "proto/words/result.h"

namespace telepalp::trials {

/// The report as JSON: figures, phases and transitions of each trial.
[[nodiscard]] std::string to_json(std::span<const TrialResult> results);

/// The report as one HTML page with plots like Fig. 5 to 8 of paper S1 (docs/sources.md): position over time, coloured
/// by phase, and force against indentation.
[[nodiscard]] std::string to_html(std::span<const TrialResult> results);

/// Writes report.json and report.html into `folder`, which is created if it does not exist.
[[nodiscard]] Result<void> write_report(std::span<const TrialResult> results, const std::filesystem::path& folder);

}  // namespace telepalp::trials
