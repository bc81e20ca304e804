#pragma once

#include <filesystem>

#include "proto/words/result.h"
#include "tools/study/experiments/experiment.h"
#include "tools/study/run/parts.h"

namespace telepalp::study {

struct ExperimentSettings {
  int observers = 12;
  std::uint64_t seed = 1;
  int threads = 1;
  std::filesystem::path out;  ///< folder of the study's files
};

/// The experiment as parts of one observer each; finished parts are files in out/runs. The parts refer to `experiment`,
/// which must outlive them.
[[nodiscard]] Parts parts_of(const Experiment& experiment, const ExperimentSettings& settings);

/// Returns the rows of all observers, in the order of the observers. Error: a file cannot be written. `finished`: as of
/// run_parts().
[[nodiscard]] Result<std::vector<Row>> run_experiment(const Experiment& experiment, const ExperimentSettings& settings,
                                                      const std::function<void(int)>& finished);

/// All rows as CSV, for trials.csv.
[[nodiscard]] std::string rows_csv(const Experiment& experiment, const ExperimentSettings& settings,
                                   const std::vector<Row>& rows);

}  // namespace telepalp::study
