#include "tools/study/commands.h"

#include "support/program/files/whole_file.h"
#include "support/program/parallel.h"
#include "tools/study/experiments/obstruction.h"
#include "tools/study/experiments/ribs.h"
#include "tools/study/experiments/stiffness.h"
#include "tools/study/page/experiment_page.h"
#include "tools/study/progress.h"

namespace telepalp::study {
namespace {

using MakeExperiment = Result<Experiment> (*)(const program::Arguments&);

Result<ExperimentSettings> read_experiment_settings(const program::Arguments& arguments) {
  const Result<std::int64_t> observers = arguments.whole("observers", 4, 10'000);
  if (!observers) return observers.error();
  const Result<RunChoice> choice = read_run_choice(arguments);
  if (!choice) return choice.error();
  return ExperimentSettings{
      .observers = static_cast<int>(*observers), .seed = choice->seed, .threads = choice->threads, .out = choice->out};
}

Result<ExperimentResult> run(const Experiment& experiment, const ExperimentSettings& settings) {
  const Result<std::vector<Row>> rows =
      run_experiment(experiment, settings, tell_progress(parts_of(experiment, settings)));
  if (!rows) return rows.error();
  const Result<ExperimentResult> result = result_of(experiment, *rows);
  if (!result) return result.error();
  for (const auto& [file, text] :
       {std::pair<const char*, std::string>{"trials.csv", rows_csv(experiment, settings, *rows)},
        {"study.json", experiment_json(experiment, settings, *result)},
        {"report.html", experiment_html(experiment, settings, *result)}})
    if (const auto written = program::write_whole_file(settings.out / file, text, program::Readers::Anyone); !written)
      return written.error();
  return result;
}

int run_command(const program::Usage& usage, int argc, const char* const* argv, MakeExperiment make) {
  return program::run_program(usage, argc, argv, [make](const program::Arguments& arguments) {
    const Result<ExperimentSettings> settings = read_experiment_settings(arguments);
    if (!settings) return program::fail(settings.error(), program::kAskedWrongly);
    const Result<Experiment> experiment = make(arguments);
    if (!experiment) return program::fail(experiment.error(), program::kAskedWrongly);
    const Result<ExperimentResult> result = run(*experiment, *settings);
    if (!result) return program::fail(result.error());
    return program::print(arguments.has("json") ? experiment_json(*experiment, *settings, *result)
                                                : experiment_text(*experiment, *result));
  });
}

program::Usage usage_of(std::string_view program, std::string_view purpose, std::string_view observers,
                        std::string_view folder, std::string_view example) {
  return {.program = program,
          .purpose = purpose,
          .positional = {},
          .options = {{"observers", "N", "number of simulated observers", observers},
                      kSeedOption,
                      kThreadsOption,
                      {"out", "DIR", kOutHelp, folder},
                      kJsonOption},
          .example = example};
}

Result<Experiment> chosen_stiffness(const program::Arguments& arguments) {
  const std::string rule = arguments.text("rule");
  if (rule == "staircase") return stiffness_experiment(ThresholdRule::Staircase);
  if (rule == "quest") return stiffness_experiment(ThresholdRule::Quest);
  return Error{.what = "'" + rule + "' is not a rule", .where = "--rule", .fix = "give staircase or quest"};
}

Result<Experiment> chosen_ribs(const program::Arguments&) {
  Result<Chest> chest = read_chest("ribs-ultrasound");
  if (!chest) return chest.error();
  return rib_experiment(std::move(*chest));
}

}  // namespace

Result<std::filesystem::path> read_out(const program::Arguments& arguments) {
  const std::string out = arguments.text("out");
  if (out.empty())
    return Error{.what = "no folder is named", .where = "--out", .fix = "give a folder, such as --out study"};
  return std::filesystem::path(out);
}

Result<std::uint64_t> read_seed(const program::Arguments& arguments) {
  const Result<std::int64_t> seed = arguments.whole("seed", 0, 1'000'000'000);
  if (!seed) return seed.error();
  return static_cast<std::uint64_t>(*seed);
}

Result<int> read_threads(const program::Arguments& arguments) {
  const Result<std::int64_t> threads = arguments.whole("threads", 0, 256);
  if (!threads) return threads.error();
  return *threads == 0 ? program::processors() : static_cast<int>(*threads);
}

Result<Design> read_design_choice(const program::Arguments& arguments) {
  const std::string design = arguments.text("design");
  return design == kDesignOption.initial ? amniocentesis_design() : read_design(design);
}

Result<RunChoice> read_run_choice(const program::Arguments& arguments) {
  const Result<std::uint64_t> seed = read_seed(arguments);
  if (!seed) return seed.error();
  const Result<int> threads = read_threads(arguments);
  if (!threads) return threads.error();
  const Result<std::filesystem::path> out = read_out(arguments);
  if (!out) return out.error();
  return RunChoice{.seed = *seed, .threads = *threads, .out = *out};
}

int run_obstruction(int argc, const char* const* argv) {
  return run_command(
      usage_of("telepalp-study obstruction",
               "simulated observers push a ball between two pockets with the haptic device in sight or hidden, as in "
               "paper S3 8.3; the study tells how much longer the way around the device takes",
               "30", "obstruction", "telepalp-study obstruction --observers 30 --seed 1"),
      argc, argv, [](const program::Arguments&) { return Result<Experiment>(obstruction_experiment()); });
}

int run_stiffness_jnd(int argc, const char* const* argv) {
  program::Usage usage = usage_of("telepalp-study stiffness-jnd",
                                  "simulated observers tell which of two prisms is stiffer, with the hand drawn where "
                                  "it is or at the tool, as in paper S3 8.4; the study finds the least difference",
                                  "10", "stiffness-jnd", "telepalp-study stiffness-jnd --observers 200 --seed 1");
  usage.options.insert(
      usage.options.begin() + 1,
      {"rule", "RULE", "staircase: 1-up-3-down for 83.15 % right; quest: 100 trials for 75 % right", "staircase"});
  return run_command(usage, argc, argv, chosen_stiffness);
}

int run_rib_count(int argc, const char* const* argv) {
  return run_command(usage_of("telepalp-study rib-count",
                              "simulated observers slide along the chest of scene ribs-ultrasound and count its ribs, "
                              "by touch alone and with the finger drawn under the skin",
                              "12", "rib-count", "telepalp-study rib-count --observers 12 --seed 1"),
                     argc, argv, chosen_ribs);
}

}  // namespace telepalp::study
