#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/study/figures/paper_table.h"
#include "tools/study/figures/statistics.h"
#include "tools/study/run/study.h"

namespace telepalp::study {

/// Overshoots in one condition of a study [mm].
struct ConditionResult {
  Condition condition = Condition::Both;
  Factorial by_operator;        ///< mean overshoot of each operator with each mechanism
  std::vector<Interval> cells;  ///< mean overshoot with each mechanism
  Interval all;                 ///< mean overshoot with all mechanisms
  double noticed_share = 0.0;   ///< share of the penetrations in which the operator noticed the puncture
  int not_through = 0;          ///< penetrations without a puncture; left out of the means
  int not_stopped = 0;          ///< penetrations in which the tip did not stop in time; they count with its last place
};

/// How the ranks of the mechanisms compare with S4's Table 2.
struct Correlation {
  double of_means = 0.0;  ///< of the means over all operators
  double least = 0.0;     ///< of single operators, each on a separate plant
  double median = 0.0;
  double most = 0.0;
};

struct StudyResult {
  int left_out = 0;  ///< operators who never punctured the sac with some mechanism in some condition; they are in no
                     ///< mean of `conditions`
  std::array<ConditionResult, kStudied.size()> conditions;
  std::array<std::optional<Correlation>, kStudied.size()> correlations;  ///< nullopt for a user's list of mechanisms
  std::vector<double> hand_drop_N;    ///< mean fall of the hand's force at the puncture, of each mechanism in Both
  double ceiling_penetrations = 0.0;  ///< noise_ceiling() if S4's deviations are over 20 penetrations
  double ceiling_subjects = 0.0;      ///< noise_ceiling() if S4's deviations are over 4 subjects
  double lever_alone = 0.0;           ///< rank correlation of 1 / (distance of the hand from O) with Table 2
  std::vector<Effect> effects;        ///< in condition Both; empty for a user's list of mechanisms
  std::vector<Pattern> patterns;      ///< in condition Both; empty for a user's list of mechanisms
  Interval force_against_vision;      ///< mean difference Force - Vision [mm]
  Interval both_against_vision;       ///< mean difference Both - Vision [mm]
  Check check;
};

/// Error: no operator punctured the sac with all mechanisms in all conditions.
[[nodiscard]] Result<StudyResult> result_of(const StudySettings& settings, const std::vector<Trial>& trials,
                                            const Check& check);

}  // namespace telepalp::study
