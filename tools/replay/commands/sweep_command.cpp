#include "tools/replay/commands/sweep_command.h"

#include <array>
#include <cstdio>

#include "support/program/files/whole_file.h"
#include "support/program/log.h"
#include "tools/replay/commands/progress_bar.h"
#include "tools/replay/commands/report.h"
#include "tools/replay/commands/run_command.h"
#include "tools/replay/commands/sweep_tables.h"

namespace telepalp::replay {
namespace {

constexpr auto kMaps = std::to_array<std::string_view>(
    {"force_rmse_N", "true_force_rmse_N", "contact_lost_pct", "surface_age_p50_s", "frames_in_time_pct"});

/// The assertions of one cell, with the cell's name in front.
std::vector<Judgement> judge_cells(const Request& request, const SweepResult& result) {
  std::vector<Judgement> all;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    std::string cell;
    for (std::size_t axis = 0; axis < result.axes.size(); ++axis) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), "%s=%g ", std::string(result.axes[axis].name).c_str(),
                    result.cells[i].values[axis]);
      cell += text.data();
    }
    for (Judgement& judgement : judge(request.assertions, result.figures[i])) {
      judgement.text = cell + judgement.text;
      all.push_back(std::move(judgement));
    }
  }
  return all;
}

Result<void> write(const Request& request, const std::string& name, const std::string& content) {
  return program::write_whole_file(request.out / name, content, program::Readers::Group);
}

/// The report of each cell, as a single run writes it.
Result<void> write_cells(const Request& request, const SweepResult& result, const RunResults& results) {
  if (const Result<void> made = program::make_folder(request.out / "cells", program::Readers::Group); !made)
    return made;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "cells/%03zu.json", i);
    const RunResults one{
        .runs = {results.runs.front(), results.runs[i + 1]}, .tape_costs = Stopwatch(), .seconds = results.seconds};
    const std::string report =
        report_json(request, result.cells[i].scenario, one, judge(request.assertions, result.figures[i]));
    if (const Result<void> written = write(request, name.data(), report); !written) return written;
  }
  return {};
}

Result<void> write_files(const Request& request, const SweepResult& result, const RunResults& results) {
  if (request.out.empty()) return {};
  if (const Result<void> written = write_cells(request, result, results); !written) return written;
  std::vector<std::pair<std::string, std::string>> files{{"sweep.txt", sweep_text(result)},
                                                         {"sweep.csv", sweep_csv(result)},
                                                         {"sweep.json", sweep_json(result, request.source)}};
  if (result.axes.size() >= 2)
    for (const std::string_view name : kMaps)
      files.emplace_back(std::string(name) + ".svg", sweep_map(result, *find_metric(name)));
  for (const auto& [name, content] : files)
    if (const Result<void> written = write(request, name, content); !written) return written;
  return {};
}

Result<void> write_junit(const Request& request, const std::vector<Judgement>& judgements) {
  if (request.junit.empty()) return {};
  return program::write_whole_file(request.junit, junit_xml(request.source, judgements), program::Readers::Anyone);
}

}  // namespace

Result<bool> run_sweep(const Request& request, const std::vector<SweepAxis>& axes,
                       const std::vector<SweepCell>& cells) {
  Result<Tape> tape = Tape::open(request.source, request.tape);
  if (!tape) return tape.error();
  std::vector<RunOrder> orders{{.scenario = unimpaired(request.scenario)}};
  for (const SweepCell& cell : cells) orders.push_back({.scenario = cell.scenario});
  const std::int64_t began_ns = steady_ns();
  ProgressBar bar(request.seconds);
  const Result<RunResults> results = run_session(*tape, request.run_settings(), std::move(orders),
                                                 [&](double seconds) { bar.show(seconds, "s of session"); });
  if (!results) return results.error();
  const double wall_s = 1e-9 * static_cast<double>(steady_ns() - began_ns);
  SweepResult result{.axes = axes, .cells = cells, .figures = {}};
  for (std::size_t i = 1; i < results->runs.size(); ++i) result.figures.push_back(results->runs[i].figures);
  std::fputs((request.json ? sweep_json(result, request.source) : sweep_text(result)).c_str(), stdout);
  const std::vector<Judgement> judgements = judge_cells(request, result);
  bool all_hold = true;
  for (const Judgement& judgement : judgements) {
    all_hold &= judgement.holds;
    if (!judgement.holds) std::printf("FAILS: %s  (%s)\n", judgement.text.c_str(), judgement.reason.c_str());
  }
  program::log("telepalp-replay", cost_in_words(*results, wall_s));
  if (const Result<void> written = write_files(request, result, *results); !written) return written.error();
  if (const Result<void> written = write_junit(request, judgements); !written) return written.error();
  return all_hold;
}

}  // namespace telepalp::replay
