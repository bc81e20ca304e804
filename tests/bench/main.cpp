#include <array>
#include <cstdio>

#include "tests/bench/accuracy_bench.h"
#include "tests/bench/benches.h"
#include "tests/bench/control_bench.h"
#include "tests/bench/depth_bench.h"
#include "tests/bench/hand/hand_bench.h"
#include "tests/bench/link/link_bench.h"
#include "tests/bench/passivity_bench.h"
#include "tests/bench/pipeline_bench.h"
#include "tests/bench/station_bench.h"
#include "tests/bench/surface_bench.h"
#include "tests/bench/synthetic_bench.h"

namespace {

using namespace telepalp;

/// All benchmarks. A new one needs a file <name>_bench.cpp, a declaration and a row here.
constexpr std::array kBenches{
    bench::Bench{"accuracy", "what accuracy costs: error against ground truth beside time, setting by setting",
                 bench::run_accuracy},
    bench::Bench{"control", "the encountered controller: tick, trials, force law, search, prediction, safety",
                 bench::run_control},
    bench::Bench{"passivity", "energy and force error of the touch behind bad links, 1000 seeded runs",
                 bench::run_passivity},
    bench::Bench{"depth", "ratio and time of each depth mode and of other codecs", bench::run_depth},
    bench::Bench{"hand", "moving patients and bad links, against the true skin",
                 bench::run_hand},
    bench::Bench{"link", "frames over bad networks, beside plain UDP, plain TCP and SRT", bench::run_link},
    bench::Bench{"pipeline", "a frame's way from the camera to the hand, and the 2 kHz loop's time",
                 bench::run_pipeline},
    bench::Bench{"station", "jitter of the 2 kHz thread, and calibration under noise",
                 bench::run_station},
    bench::Bench{"synthetic", "what the synthetic patient costs, and how true it is", bench::run_synthetic},
    bench::Bench{"surface", "touching a noisy, moving cloud: cost, error and steadiness", bench::run_surface},
};

program::Usage usage() {
  program::Usage usage{
      .program = "telepalp-bench",
      .purpose = "measures one part of telepalp against the figures asked of it",
      .positional = {},
      .options = {{"json", "", "print JSON instead of a table"},
                  {"list", "", "name the benchmarks and leave"},
                  {"input", "FILE|DIR", "what to run on, where a benchmark takes one"},
                  {"held-out", "SET,SET…", "depth: frames never trained on, for the mean ratio"},
                  {"part", "NAME", "accuracy: surface, patients, prediction, organ, z-width or depth alone"},
                  {"write", "DIR", "also write a benchmark's file: accuracy.md, or hand's reached.tsv"},
                  {"depth-mode", "MODE", "pipeline: how the server compresses depth", "fast"},
                  {"row", "PART,PART…", "hand: the studies whose name contains a PART alone"},
                  {"reached", "FILE", "hand: a missed row passes while no worse than in FILE"},
                  {"seeds", "N", "hand: runs where a study draws", "200"},
                  {"seconds", "S", "how long, where a benchmark takes time", "10"}},
      .example = "telepalp-bench pipeline --json",
      .commands = {},
      .needs_command = true};
  for (const bench::Bench& bench : kBenches) usage.commands.push_back({bench.name, "", bench.purpose});
  return usage;
}

int list() {
  for (const bench::Bench& bench : kBenches)
    std::printf("%-12.*s %.*s\n", static_cast<int>(bench.name.size()), bench.name.data(),
                static_cast<int>(bench.purpose.size()), bench.purpose.data());
  return program::kDone;
}

int run(const bench::Bench& bench, const program::Arguments& arguments) {
  const Result<bench::Report> report = bench.run(arguments);
  if (!report) return program::fail(report.error());
  std::fputs((arguments.has("json") ? to_json(*report) : to_table(*report)).c_str(), stdout);
  return report->holds() ? program::kDone : program::kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  const Result<std::optional<program::Arguments>> read = program::read_arguments(usage(), argc, argv);
  if (!read) return program::fail(read.error(), program::kAskedWrongly);
  if (!*read) return program::kDone;
  const program::Arguments& arguments = **read;
  if (arguments.has("list")) return list();
  const std::string wanted = arguments.positional().size() == 1 ? arguments.positional().front() : "";
  for (const bench::Bench& bench : kBenches)
    if (bench.name == wanted) return run(bench, arguments);
  return program::fail(
      {.what = "'" + wanted + "' is not a benchmark", .where = "telepalp-bench", .fix = "telepalp-bench --list"},
      program::kAskedWrongly);
}
