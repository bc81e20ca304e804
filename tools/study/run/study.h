#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "proto/words/result.h"
#include "tools/study/run/parts.h"
#include "tools/study/task/penetration.h"

namespace telepalp::study {

struct StudySettings {
  Design design;
  int operators = 12;
  std::uint64_t seed = 1;
  int penetrations = 5;  ///< of each mechanism by each operator in each condition
  int threads = 1;
  std::filesystem::path out;
};

/// One formal penetration; training runs are not kept.
struct Trial {
  std::size_t person = 0;
  Condition condition = Condition::Both;
  std::size_t place = 0;          ///< position of the mechanism in this operator's random order
  std::size_t configuration = 0;  ///< index of the mechanism in the design
  int penetration = 0;
  Outcome outcome;
};

/// An operator and the plant on which this operator works.
struct Person {
  Operator self;
  Plant plant;
};
[[nodiscard]] Person person_of(const StudySettings& settings, std::size_t number) noexcept;

/// Runs the study in parts (parts_of()), whose files are in out/runs. Returns its trials in the order of operators and
/// conditions. `finished`: as of run_parts(). Error: a mechanism cannot be used on an operator's plant, or a file
/// cannot be written.
[[nodiscard]] Result<std::vector<Trial>> run_study(const StudySettings& settings,
                                                   const std::function<void(int)>& finished);
/// The study as parts of one operator in one condition each, to count the finished ones. Only run_study() may call
/// Parts::make, which needs the tissues.
[[nodiscard]] Parts parts_of(const StudySettings& settings);

/// The check of the operator against Gerovich 2004: a straight needle, overshoot after the puncture [m] of each
/// condition, mean of all operators.
struct Check {
  double neither_m = 0.0;
  double force_m = 0.0;
  double sees_layers_m = 0.0;
  double both_m = 0.0;  ///< force, and sight of the needle outside the skin
};
[[nodiscard]] Result<Check> check_operators(const StudySettings& settings);

}  // namespace telepalp::study
