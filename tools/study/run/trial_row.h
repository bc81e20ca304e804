#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/study/run/study.h"

namespace telepalp::study {

inline constexpr std::string_view kTrialColumns =
    "operator,condition,place,configuration,penetration,through,stopped,noticed,overshoot_m,deepest_m,"
    "depth_at_puncture_m,hand_drop_N,most_hand_N,seconds";

/// A trial as one row of CSV, in the order of kTrialColumns. read_trial() gives back exactly the same numbers.
[[nodiscard]] std::string trial_row(const Trial& trial);
/// nullopt: the row is no trial.
[[nodiscard]] std::optional<Trial> read_trial(const std::string& row);

/// A checksum of all mechanisms and of all ranges from which operators and plants are drawn.
[[nodiscard]] std::uint32_t design_checksum(const Design& design);

/// All on which a study's numbers depend, in one line: program, seed, counts, and a checksum of mechanisms and ranges.
[[nodiscard]] std::string identity_of(const StudySettings& settings);

}  // namespace telepalp::study
