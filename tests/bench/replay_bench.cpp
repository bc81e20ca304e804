#include "tests/bench/replay_bench.h"

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

#include "support/program/files/shipped.h"
#include "support/program/parallel.h"
#include "tools/replay/run/session_run.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using replay::RunOrder;
using replay::RunResults;
using replay::Scenario;

constexpr const char* kSource = "synthetic:torso,motion=irregular";
constexpr std::size_t kDelays = 7;
constexpr std::array kLosses{0.0, 0.01, 0.05, 0.1};

std::int64_t clock_ns(clockid_t clock) noexcept {
  timespec now{};
  clock_gettime(clock, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}
double processor_s() { return 1e-9 * static_cast<double>(clock_ns(CLOCK_PROCESS_CPUTIME_ID)); }
std::int64_t thread_ns() noexcept { return clock_ns(CLOCK_THREAD_CPUTIME_ID); }

std::int64_t steady_ns() noexcept { return clock_ns(CLOCK_MONOTONIC); }

Scenario network(Nanoseconds delay, double loss) {
  Scenario scenario;
  scenario.down = scenario.up = {.delay = delay, .jitter = delay / 5, .loss = loss, .burst_packets = 4.0};
  scenario.deadline = 100ms + delay;
  return scenario;
}

/// The 28 networks of a grid of delays and losses.
std::vector<Scenario> grid() {
  std::vector<Scenario> cells;
  for (std::size_t delay = 0; delay < kDelays; ++delay)
    for (const double loss : kLosses) cells.push_back(network(delay * 50ms, loss));
  return cells;
}

struct Measured {
  RunResults results;
  double wall_s = 0.0;
  double processor_s = 0.0;
  std::uint64_t digest = 14695981039346656037ULL;  ///< FNV-1a of all that the last run published
};

/// Runs the synthetic patient over `networks`; the unimpaired network comes first if `compared`.
Result<Measured> measure(const std::vector<Scenario>& networks, bool compared, double seconds, int threads) {
  const auto file = program::shipped_file("haptic_station/scenes/palpation.scene.textproto");
  const Result<scenes::Scene> scene = scenes::read_scene(file.value());
  if (!scene) return scene.error();
  Result<replay::Tape> tape = replay::Tape::open(kSource, {.clock = thread_ns});
  if (!tape) return tape.error();
  Measured outcome;
  std::vector<RunOrder> orders;
  if (compared) orders.push_back({.scenario = unimpaired(networks.front())});
  for (const Scenario& one : networks) orders.push_back({.scenario = one});
  orders.back().publish = [&outcome](const wire::Message& message) {
    for (const char byte : *message.payload)
      outcome.digest = (outcome.digest ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  };
  const double processor_began_s = processor_s();
  const std::int64_t began_ns = steady_ns();
  Result<RunResults> results =
      run_session(*tape, {.scene = *scene, .surface = {}, .recorded = nullptr, .seconds = seconds, .threads = threads},
                  std::move(orders));
  if (!results) return results.error();
  outcome.wall_s = 1e-9 * static_cast<double>(steady_ns() - began_ns);
  outcome.processor_s = processor_s() - processor_began_s;
  outcome.results = std::move(*results);
  return outcome;
}

void add_parts(const Measured& one, Report& report) {
  replay::Stopwatch total = one.results.tape_costs;
  for (const replay::RunResult& run : one.results.runs) total.add(run.costs);
  for (std::size_t i = 0; i < replay::kPartCount; ++i)
    report.rows.push_back(
        measured(std::string("of these: ") + replay::kPartNames[i],
                 1e-6 * static_cast<double>(total.cost_ns(static_cast<replay::Part>(i))) / one.results.seconds,
                 "ms of processor a second"));
}

}  // namespace

Result<Report> run_replay(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 1.0, 600.0);
  if (!seconds) return seconds.error();
  const Scenario bad = network(80ms, 0.05);
  const Result<Measured> alone = measure({bad}, false, *seconds, 1);
  if (!alone) return alone.error();
  const Result<Measured> pair = measure({bad}, true, *seconds, 1);
  if (!pair) return pair.error();
  const Result<Measured> threads = measure({bad}, true, *seconds, 4);
  if (!threads) return threads.error();
  const Result<Measured> sweep = measure(grid(), true, *seconds, program::processors());
  if (!sweep) return sweep.error();
  Report report{.bench = "replay", .rows = {}, .notes = {}};
  report.rows.push_back(at_least("one run of 640x480 at 30 Hz, 2 kHz, one core, decoding included",
                                 alone->results.seconds / alone->processor_s, "times real time", 5.0));
  add_parts(*alone, report);
  report.rows.push_back(measured("the same with the unimpaired run to compare with, one core",
                                 pair->results.seconds / pair->processor_s, "times real time"));
  report.rows.push_back(
      at_most("a sweep of 28 cells, all cores, to one replay on one core", sweep->wall_s / pair->wall_s, "", 8.0));
  report.rows.push_back(
      measured("processor time of the sweep to that of one replay", sweep->processor_s / pair->processor_s, ""));
  report.rows.push_back(at_most("runs whose bytes differ on one and on four threads",
                                pair->digest == threads->digest ? 0.0 : 1.0, "", 0.0));
  report.notes.push_back(std::string(kSource) + ", scene palpation, 80 ms one way, 5 % lost in bursts of four");
  return report;
}

}  // namespace telepalp::bench
