#include <array>
#include <cstdio>
#include <string>

#include "haptic_station/surface/pcl_search/pcl_indexes.h"
#include "support/program/ending.h"
#include "tests/bench/accuracy/accuracy_bench.h"
#include "tests/bench/benches.h"
#include "tests/bench/cluster/cluster_bench.h"
#include "tests/bench/control_bench.h"
#include "tests/bench/depth/depth_bench.h"
#include "tests/bench/effects/effects_bench.h"
#include "tests/bench/hand/hand_bench.h"
#include "tests/bench/link/link_bench.h"
#include "tests/bench/link/subscribers_bench.h"
#include "tests/bench/mixed/mixed_bench.h"
#include "tests/bench/needle/needle_bench.h"
#include "tests/bench/passivity_bench.h"
#include "tests/bench/pipeline_bench.h"
#include "tests/bench/replay_bench.h"
#include "tests/bench/session/session_bench.h"
#include "tests/bench/site/site_bench.h"
#include "tests/bench/station_bench.h"
#include "tests/bench/surface_bench.h"
#include "tests/bench/synthetic_bench.h"
#include "tests/bench/thin/thin_bench.h"
#include "tests/bench/users/users_bench.h"

namespace {

using namespace telepalp;

/// All benchmarks. A new one needs a file <name>_bench.cpp, a declaration and a row here.
constexpr std::array kBenches{
    bench::Bench{"accuracy", "error against ground truth and computing time of each setting", bench::run_accuracy},
    bench::Bench{"cluster", "relay through NATS to an edge; a lost node; sweeps by workers", bench::run_cluster},
    bench::Bench{"control", "the haptic controller: time of a tick, trials, force law, safety", bench::run_control},
    bench::Bench{"passivity", "energy balance and force error over bad networks, 1000 runs", bench::run_passivity},
    bench::Bench{"depth", "compression ratio and time of each depth mode and other codecs", bench::run_depth},
    bench::Bench{"effects", "solids under the skin: time, gradient, search, ultrasound image", bench::run_effects},
    bench::Bench{"hand", "error of the force at the hand, on moving patients", bench::run_hand},
    bench::Bench{"link", "frames in time over bad networks, compared with UDP, TCP, SRT", bench::run_link},
    bench::Bench{"subscribers", "the server: cost of a subscriber, fairness among 200, stalls", bench::run_subscribers},
    bench::Bench{"mixed", "mixed reality: calibration, masks, background, hand at the tool", bench::run_mixed},
    bench::Bench{"needle", "needles in layers of tissue: time, energy, force, relaxation", bench::run_needle},
    bench::Bench{"pipeline", "latency from camera to hand, timing of the 2 kHz loop", bench::run_pipeline},
    bench::Bench{"replay", "speed of telepalp-replay, and agreement with real sockets", bench::run_replay},
    bench::Bench{"session", "time to seek in a session of 2 GB, and the cost of recording", bench::run_session},
    bench::Bench{"site", "two sites in network namespaces, beside other traffic", bench::run_site},
    bench::Bench{"station", "jitter of the 2 kHz thread, and calibration under noise", bench::run_station},
    bench::Bench{"synthetic", "time and depth error of the synthetic patient", bench::run_synthetic},
    bench::Bench{"surface", "touch of a noisy, moving surface: time, error and steadiness", bench::run_surface},
    bench::Bench{"thin", "depth in a window, colour as video: bytes, accuracy, time", bench::run_thin},
    bench::Bench{"users", "programs and page, driven as a user drives them, under faults", bench::run_users},
};

program::Usage usage() {
  program::Usage usage{.program = "telepalp-bench",
                       .purpose = "measures one part of telepalp and compares it with its budget",
                       .positional = {},
                       .options = {{"json", "", "print JSON instead of a table"},
                                   {"input", "FILE|DIR", "depth, hand, needle, thin: data; link, pipeline: a --source"},
                                   {"part", "NAME", "accuracy, cluster, mixed, needle, site, thin, users: a part"},
                                   {"write", "DIR", "accuracy, hand: write accuracy.md or reached.tsv"},
                                   {"depth-mode", "MODE", "pipeline: how the server compresses depth", "fast"},
                                   {"row", "PART,PART…", "hand, site: only studies whose names contain a PART"},
                                   {"reached", "FILE", "hand: accept a miss up to 10 % beyond its value in FILE"},
                                   {"seeds", "N", "hand: number of runs of a study with random runs", "200"},
                                   {"seconds", "S", "duration of a run, in most benchmarks", "10"}},
                       .example = "telepalp-bench pipeline --json",
                       .commands = {},
                       .needs_command = true};
  for (const bench::Bench& bench : kBenches) usage.commands.push_back({bench.name, "", bench.purpose});
  return usage;
}

int run(const bench::Bench& bench, const program::Arguments& arguments) {
  program::say_when_stopped("telepalp-bench: stopped: the figures of " + std::string(bench.name) +
                            " come at its end, so none are kept");
  const Result<bench::Report> report = bench.run(arguments);
  if (!report) return program::fail(report.error());
  std::fputs((arguments.has("json") ? to_json(*report) : to_table(*report)).c_str(), stdout);
  return report->holds() ? program::kDone : program::kFailed;
}

int run_asked(const program::Arguments& arguments) {
  const std::string wanted = arguments.positional().size() == 1 ? arguments.positional().front() : "";
  for (const bench::Bench& bench : kBenches)
    if (bench.name == wanted) return run(bench, arguments);
  return program::fail({.what = wanted.empty() ? "the command line does not name exactly one benchmark"
                                               : "'" + wanted + "' is not a benchmark",
                        .where = "telepalp-bench",
                        .fix = "to see the names: telepalp-bench --help"},
                       program::kAskedWrongly);
}

}  // namespace

int main(int argc, char** argv) {
  surface::use_pcl_indexes();
  return program::run_program(usage(), argc, argv, run_asked);
}
