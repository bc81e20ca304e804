#include "tools/replay/sweep/sweep_command.h"

#include <array>
#include <cstdio>

#include "proto/words/counted.h"
#include "support/program/files/whole_file.h"
#include "tools/replay/commands/progress_bar.h"
#include "tools/replay/commands/report.h"
#include "tools/replay/commands/run_command.h"
#include "tools/replay/commands/sweep_cells.h"
#include "tools/replay/commands/sweep_tables.h"
#include "tools/replay/words/say.h"
#include "tools/replay/workers/shared_sweep.h"

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

Result<void> write_files(const Request& request, const SweepResult& result) {
  if (request.out.empty()) return {};
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

/// Makes the cells that are not finished, batch by batch, until all are finished or a signal comes. Each batch makes
/// the unimpaired run again, so that finished cells can be kept; a batch has four cells for each thread, so that this
/// costs little. Returns the runs that were made.
Result<RunResults> make_cells(const Request& request, FinishedCells& finished) {
  RunResults made;
  const auto in_a_batch = static_cast<std::size_t>(4 * request.threads);
  ProgressBar bar(static_cast<double>(request.cells.size()));
  for (auto batch = finished.next(in_a_batch); !batch.empty(); batch = finished.next(in_a_batch)) {
    Result<Tape> tape = Tape::open(request.source, request.tape);
    if (!tape) return tape.error();
    std::vector<RunOrder> orders{{.scenario = unimpaired(request.scenario)}};
    for (const std::size_t cell : batch) orders.push_back({.scenario = request.cells[cell].scenario});
    bar.show(static_cast<double>(finished.count()), "runs");
    const Result<RunResults> results =
        run_session(*tape, request.run_settings(&StopOnSignal::stopped()), std::move(orders));
    if (!results && StopOnSignal::stopped()) return made;
    if (!results) return results.error();
    if (const Result<void> added = finished.add(batch, *results); !added) return added.error();
    made.runs.insert(made.runs.end(), results->runs.begin(), results->runs.end());
    made.tape_costs.add(results->tape_costs);
    made.seconds = results->seconds;
  }
  return made;
}

/// Says what a signal has left unfinished, and prints the finished cells if no file keeps them.
void say_stopped(const Request& request, const FinishedCells& finished) {
  const std::string cells = "stopped: " + std::to_string(finished.count()) + " of " +
                            std::to_string(request.cells.size()) + " runs of the sweep are finished";
  if (!request.out.empty()) {
    std::fprintf(stderr, "%s, and kept in %s; resume with the same command:\n  %s\n", cells.c_str(),
                 (request.out / "cells").c_str(), request.command.c_str());
    if (request.workers && request.workers->url != nats::without_password(request.workers->url))
      std::fputs("add USER:PASSWORD@ to the address of --workers again: this line does not show them\n", stderr);
    return;
  }
  std::vector<SweepCell> done;
  SweepResult result{.axes = request.axes, .cells = done, .figures = {}};
  for (std::size_t i = 0; i < request.cells.size(); ++i)
    if (finished.figures()[i]) {
      done.push_back(request.cells[i]);
      result.figures.push_back(*finished.figures()[i]);
    }
  std::fputs(sweep_text(result).c_str(), stdout);
  std::fprintf(stderr, "%s, and printed; no file keeps them, because --out is not given\n", cells.c_str());
}

/// Lets workers make the cells. The results hold no runs, so that no costs are printed: they arise on other computers.
Result<RunResults> let_workers_make_cells(const Request& request, FinishedCells& finished) {
  const Result<SharedOutcome> outcome = share_sweep(request, finished, StopOnSignal::stopped());
  if (!outcome) return outcome.error();
  if (outcome->ordered > 0)
    std::fprintf(stderr, "workers go on with %zu runs; the same command takes their results within seven days\n",
                 outcome->ordered);
  if (!outcome->refused.empty())
    return Error{.what = counted(outcome->refused.size(), "run was", "runs were") + " given up by the workers, first " +
                         program::escaped(outcome->refused.front()),
                 .where = "--workers",
                 .fix = "remove the cause, and give the same command again: it makes the missing runs only"};
  return RunResults{.runs = {}, .tape_costs = Stopwatch()};
}

}  // namespace

Result<bool> run_sweep(const Request& request) {
  const StopOnSignal until_signalled;
  FinishedCells finished(request);
  if (finished.kept() > 0)
    say(std::to_string(finished.kept()) + " of " + std::to_string(request.cells.size()) +
        " runs of the sweep were finished before, and are not made again");
  const std::int64_t began_ns = steady_ns();
  const Result<RunResults> made =
      request.workers ? let_workers_make_cells(request, finished) : make_cells(request, finished);
  if (!made) return made.error();
  if (finished.count() < request.cells.size()) {
    say_stopped(request, finished);
    return false;
  }
  const double wall_s = 1e-9 * static_cast<double>(steady_ns() - began_ns);
  SweepResult result{.axes = request.axes, .cells = request.cells, .figures = {}};
  for (const std::optional<Figures>& one : finished.figures()) result.figures.push_back(*one);
  std::fputs((request.json ? sweep_json(result, request.source) : sweep_text(result)).c_str(), stdout);
  const std::vector<Judgement> judgements = judge_cells(request, result);
  bool all_hold = true;
  for (const Judgement& judgement : judgements) {
    all_hold &= judgement.holds;
    if (!judgement.holds) std::printf("FAILS: %s  (%s)\n", judgement.text.c_str(), judgement.reason.c_str());
  }
  if (!made->runs.empty()) say(cost_in_words(*made, wall_s));
  if (const Result<void> written = write_files(request, result); !written) return written.error();
  if (const Result<void> written = write_junit(request, judgements); !written) return written.error();
  return all_hold;
}

}  // namespace telepalp::replay
