#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/report/compare/tolerance.h"

namespace telepalp::report {

/// Whether two runs differ by more than the tolerances, and why.
struct GateOutcome {
  std::vector<Difference> differences;
  std::vector<std::string> causes;  ///< the most likely first; empty if the gate holds

  /// True if all differences are within their tolerances, and at least one of them could be measured.
  [[nodiscard]] bool holds() const noexcept;
};

[[nodiscard]] GateOutcome judge_against(const Comparison& comparison, const std::vector<Tolerance>& tolerances);

/// Compares the run `b` with the baseline `a`: session files, or folders that telepalp-replay wrote. Error: one of them
/// cannot be read.
[[nodiscard]] Result<GateOutcome> judge_against(const std::filesystem::path& a, const std::filesystem::path& b,
                                                const std::vector<Tolerance>& tolerances);

/// "force_rms_N is 0.21 N, tolerance 0.1 N"; "contact_mm is not measured".
[[nodiscard]] std::string in_words(const Difference& difference);

/// One line for each difference, then the causes. A is the baseline, B the run.
[[nodiscard]] std::string in_words(const GateOutcome& outcome);

/// The session file that a user means by `asked`: itself, or session.mcap in the folder `asked`.
[[nodiscard]] std::filesystem::path session_file(const std::filesystem::path& asked);

}  // namespace telepalp::report
