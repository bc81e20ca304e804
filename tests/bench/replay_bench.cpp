#include "tests/bench/replay_bench.h"

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

#include "proto/wire/mcap/writer.h"
#include "server/pipeline/camera_messages.h"
#include "support/program/files/shipped.h"
#include "support/program/parallel.h"
#include "tests/bench/session/replay_live.h"
#include "tests/support/child_process.h"
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

Result<scenes::Scene> palpation() {
  return scenes::read_scene(*program::shipped_file("haptic_station/scenes/palpation.scene.textproto"));
}

/// Records the camera of `source`, as a recorder at the server would.
Result<void> record(const std::string& source, const std::filesystem::path& file, double seconds) {
  Result<wire::McapWriter> writer = wire::McapWriter::open(file, {});
  if (!writer) return writer.error();
  Result<replay::Tape> tape = replay::Tape::open(source, {});
  if (!tape) return tape.error();
  const Result<replay::TapeFrames> frames = tape->read_until(replay::kBegin + from_seconds(seconds));
  if (!frames) return frames.error();
  for (const auto& taped : *frames) {
    const SessionTime captured = taped->frame.captured;
    std::vector<wire::Message> messages{
        wire::make_message(wire::kCameraInfo, captured, pipeline::calibration_message(taped->frame)),
        {wire::kCameraDepth, captured, std::make_shared<const std::string>(taped->depth), 0, true}};
    if (!taped->color.empty())
      messages.push_back({wire::kCameraColor, captured, std::make_shared<const std::string>(taped->color), 0, true});
    for (const wire::Message& message : messages)
      if (const Result<void> written = writer->write(message); !written) return written;
  }
  return writer->close();
}

/// Runs `source` over `networks`; the unimpaired network comes first if `compared`.
Result<Measured> measure(const std::string& source, const std::vector<Scenario>& networks, bool compared,
                         double seconds, int threads) {
  const Result<scenes::Scene> scene = palpation();
  if (!scene) return scene.error();
  Result<replay::Tape> tape = replay::Tape::open(source, {.clock = thread_ns});
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

void add_parts(const std::string& whose, const Measured& one, Report& report) {
  replay::Stopwatch total = one.results.tape_costs;
  for (const replay::RunResult& run : one.results.runs) total.add(run.costs);
  for (std::size_t i = 0; i < replay::kPartCount; ++i)
    report.rows.push_back(
        measured(whose + ": processor time, part " + replay::kPartNames[i],
                 1e-6 * static_cast<double>(total.cost_ns(static_cast<replay::Part>(i))) / one.results.seconds,
                 "ms per s of the run"));
}

/// The speed of one run of each kind of source.
Result<void> add_sources(const Scenario& scenario, double seconds, Report& report) {
  const auto oni = program::shipped_file("deploy/demo_data/oni/3dj_test.oni");
  if (!oni)
    return Error{.what = "the recording deploy/demo_data/oni/3dj_test.oni is missing",
                 .where = "telepalp-bench replay",
                 .fix = "build telepalp-bench in the repository, and unset TELEPALP_HOME"};
  const std::string kinect = "oni:" + oni->string();
  const support::TemporaryFolder folder;
  const std::string patients = (folder.path() / "patient.mcap").string();
  const std::string kinects = (folder.path() / "kinect.mcap").string();
  for (const auto& [source, file] : {std::pair{std::string(kSource), patients}, std::pair{kinect, kinects}})
    if (const Result<void> recorded = record(source, file, seconds); !recorded) return recorded;
  struct Source {
    const char* name;
    std::string source;
    bool is_session;
  };
  for (const Source& row :
       {Source{"session of a Kinect", kinects, true}, Source{"session of the simulated patient", patients, true},
        Source{".oni recording, encoded during the run", kinect, false},
        Source{"simulated patient, rendered and encoded during the run", kSource, false}}) {
    const Result<Measured> one = measure(row.source, {scenario}, false, seconds, 1);
    if (!one) return one.error();
    const std::string name = "speed of one run on one core, decoding included: " + std::string(row.name);
    const double speed = one->results.seconds / one->processor_s;
    report.rows.push_back(row.is_session ? at_least(name, speed, "times real time", 5.0)
                                         : measured(name, speed, "times real time"));
    add_parts(row.name, *one, report);
  }
  return {};
}

/// Differences between a replay in virtual time and the same replay over real sockets. At least 10 s long, so that one
/// frame is less than 1 % of the frames.
Result<void> add_live(const Scenario& scenario, double seconds, Report& report) {
  const Result<scenes::Scene> scene = palpation();
  if (!scene) return scene.error();
  const auto both = compare_live(kSource, *scene, scenario, std::max(seconds, 10.0));
  if (!both) return both.error();
  const replay::Figures& there = both->in_virtual_time;
  const replay::Figures& live = both->live;
  report.rows.push_back(at_most("real sockets: share of frames in time, difference from virtual time",
                                std::abs(live.frames_in_time_pct - there.frames_in_time_pct), "% points", 1.0));
  report.rows.push_back(at_most("real sockets: force RMSE, difference from virtual time",
                                100.0 * std::abs(live.force_rmse_N / there.force_rmse_N - 1.0), "%", 10.0));
  report.rows.push_back(measured("virtual time: share of frames in time", there.frames_in_time_pct, "%"));
  report.rows.push_back(measured("virtual time: force RMSE", 1e3 * there.force_rmse_N, "mN"));
  report.rows.push_back(
      measured("real sockets: greatest lateness of a tick (large: the machine is too slow to compare)",
               1e3 * both->latest_s, "ms"));
  report.rows.push_back(
      measured("real sockets: run with real-time priority (1: yes, 0: no)", both->realtime ? 1.0 : 0.0, ""));
  return {};
}

}  // namespace

Result<Report> run_replay(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 1.0, 600.0);
  if (!seconds) return seconds.error();
  const Scenario bad = network(80ms, 0.05);
  Report report{.bench = "replay", .rows = {}, .notes = {}};
  if (const Result<void> added = add_sources(bad, *seconds, report); !added) return added.error();
  const Result<Measured> pair = measure(kSource, {bad}, true, *seconds, 1);
  if (!pair) return pair.error();
  const Result<Measured> threads = measure(kSource, {bad}, true, *seconds, 4);
  if (!threads) return threads.error();
  const Result<Measured> sweep = measure(kSource, grid(), true, *seconds, program::processors());
  if (!sweep) return sweep.error();
  report.rows.push_back(measured("speed of a run and its unimpaired run together, simulated patient, one core",
                                 pair->results.seconds / pair->processor_s, "times real time"));
  report.rows.push_back(at_most("wall time of a sweep of 28 runs on all cores, divided by that of one run on one core",
                                sweep->wall_s / pair->wall_s, "", 8.0));
  report.rows.push_back(measured("processor time of a sweep of 28 runs, divided by that of one run",
                                 sweep->processor_s / pair->processor_s, ""));
  report.rows.push_back(at_most("messages differ between one and four threads (1: yes, 0: no)",
                                pair->digest == threads->digest ? 0.0 : 1.0, "", 0.0));
  if (const Result<void> added = add_live(bad, *seconds, report); !added) return added.error();
  report.notes.push_back(std::string(kSource) + ", scene palpation, 80 ms one way, 5 % lost in bursts of four");
  return report;
}

}  // namespace telepalp::bench
