#pragma once

#include <string>

#include "tools/study/run/experiment_run.h"

namespace telepalp::study {

/// A measure with its test. `people`: how many people a study needs for a power of 0.8, if the effect is this one: in
/// each group between subjects, in all within subjects.
struct Compared {
  Measure measure;
  Sample first;
  Sample second;
  TTest test;
  int people = 0;
};

struct ExperimentResult {
  std::vector<Compared> compared;
  std::vector<std::string> findings;
  std::vector<Curves> curves;
};
/// Welch's test between subjects, the paired test within subjects. Error: fewer than two observers in a condition.
[[nodiscard]] Result<ExperimentResult> result_of(const Experiment& experiment, const std::vector<Row>& rows);

/// A table for a terminal, study.json, and a self-contained page without scripts.
[[nodiscard]] std::string experiment_text(const Experiment& experiment, const ExperimentResult& result);
[[nodiscard]] std::string experiment_json(const Experiment& experiment, const ExperimentSettings& settings,
                                          const ExperimentResult& result);
[[nodiscard]] std::string experiment_html(const Experiment& experiment, const ExperimentSettings& settings,
                                          const ExperimentResult& result);

}  // namespace telepalp::study
