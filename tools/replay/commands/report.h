#pragma once

#include <string>
#include <vector>

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// The text of report.txt: the settings of the run, its metrics beside those of the unimpaired run, and the assertions.
/// The same run gives the same text.
[[nodiscard]] std::string report_text(const Request& request, const RunResults& results,
                                      const std::vector<Judgement>& judgements);

/// The text of report.json, with the figures of report_text(), all settings, and how the run is made again.
/// `scenario`: the scenario of the impaired run. `options`: of the command line that makes this run alone.
[[nodiscard]] std::string report_json(const Request& request, const Scenario& scenario, const RunOptions& options,
                                      const RunResults& results, const std::vector<Judgement>& judgements);

/// Writes junit_xml() to the file of --junit; without it nothing. Error: the file cannot be written.
[[nodiscard]] Result<void> write_junit(const Request& request, const std::vector<Judgement>& judgements);

/// The assertions in the form that continuous integration servers read (JUnit's XML). `suite`: name of the run.
[[nodiscard]] std::string junit_xml(const std::string& suite, const std::vector<Judgement>& judgements);

/// The speed, and the share of each part in the processor time. The same run gives a different text each time.
[[nodiscard]] std::string cost_in_words(const RunResults& results, double wall_s);

/// The network towards the station, the other direction if it differs, the faults and the seed in one line: "80 ms
/// delay one way ± 15 ms, 5 % lost in bursts of 4 packets on average; seed 1".
[[nodiscard]] std::string in_words(const Scenario& scenario);

}  // namespace telepalp::replay
