#include "tests/bench/station_bench.h"

#include <chrono>
#include <memory>
#include <thread>

#include "haptic_station/loop/plane_snapshot.h"
#include "haptic_station/loop/simulated_rig.h"
#include "haptic_station/station/threads/haptic_thread.h"
#include "tests/bench/distribution.h"
#include "tests/haptic_station/calibration/registration_trial.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// The load of a machine varies, so both threads are measured alternately in short turns.
constexpr auto kTurn = 500ms;

/// Lateness of one thread.
struct Jitter {
  Distribution late_us;
  Distribution work_us;
  std::uint64_t missed = 0;
  bool realtime = false;
};

/// A thread like the haptic thread, which only waits for its next deadline.
void idle_turn(Jitter& jitter) {
  std::thread idle([&jitter] {
    const Result<station::RealtimeGrant> granted = station::enter_realtime(station::Realtime::Prefer);
    jitter.realtime = granted && granted->both();
    station::TickTimer timer(Clock::now() + loop::kTickPeriod, loop::kTickPeriod);
    for (const auto end = Clock::now() + kTurn; Clock::now() < end;) {
      const station::TickTimer::Tick tick = timer.wait();
      jitter.late_us.add(std::chrono::duration<double, std::micro>(tick.late).count());
      jitter.missed += tick.missed;
    }
  });
  idle.join();
}

/// The station's own loop, thread and telemetry, over a level skin and a hand that palpates it.
class Station {
 public:
  Station()
      : loop_({}, control::EncounteredController({}, skin())),
        rig_({.device = {}, .hand = {}, .tracker = {}, .rest = {{0.0, 0.05, 0.0}}},
             device::ScriptedIntention(device::waypoints(device::Trial::IndentSeveralPoints), {})) {}

  Result<void> turn(Jitter& jitter) {
    station::HapticThread thread(loop_, rig_, surfaces_, *ticks_, device_to_surface_);
    publish_surface();
    const Result<station::RealtimeGrant> started = thread.start(station::Realtime::Prefer);
    if (!started) return started.error();
    jitter.realtime = started->both();
    for (const auto end = Clock::now() + kTurn; Clock::now() < end; std::this_thread::sleep_for(33ms)) {
      publish_surface();
      drain(jitter);
    }
    thread.stop();
    drain(jitter);
    jitter.missed += thread.counts().deadlines_missed.load();
    return {};
  }

 private:
  static effects::EffectBank skin() {
    effects::EffectBank bank;
    (void)bank.add(effects::Skin());
    return bank;
  }
  void publish_surface() {
    const auto plane = std::make_shared<loop::PlaneSnapshot>(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY(), 1.0);
    plane->captured = SessionTime(Clock::now().time_since_epoch());
    surfaces_.put({plane, {}});
  }
  void drain(Jitter& jitter) {
    for (loop::TickSample tick; ticks_->try_pop(tick);) {
      jitter.late_us.add(tick.late_ns * 1e-3);
      jitter.work_us.add(static_cast<double>(tick.work_us));
    }
  }

  loop::HapticLoop loop_;
  loop::SimulatedRig rig_;
  LatestValue<loop::TouchableSurface> surfaces_;
  LatestValue<Point<HapticBase>> device_to_surface_;
  std::unique_ptr<station::TickRing> ticks_ = std::make_unique<station::TickRing>();
};

void add_rows(const std::string& name, const Jitter& jitter, Report& report) {
  report.rows.push_back(measured(name + ": lateness of a wake-up, p50", jitter.late_us.p50(), "us"));
  report.rows.push_back(measured(name + ": lateness of a wake-up, p99", jitter.late_us.p99(), "us"));
  report.rows.push_back(measured(name + ": lateness of a wake-up, p99.9", jitter.late_us.p999(), "us"));
  report.rows.push_back(measured(name + ": lateness of a wake-up, max", jitter.late_us.max(), "us"));
  const double ticks = static_cast<double>(jitter.late_us.count() + jitter.missed);
  report.rows.push_back(
      measured(name + ": share of deadlines missed", 100.0 * static_cast<double>(jitter.missed) / ticks, "%"));
}

Result<void> measure_jitter(double seconds, Report& report) {
  Jitter idle;
  Jitter busy;
  Station station;
  for (auto left = from_seconds(seconds); left > 0s; left -= 2 * kTurn) {
    idle_turn(idle);
    if (const Result<void> done = station.turn(busy); !done) return done.error();
  }
  add_rows("2 kHz thread that only waits", idle, report);
  add_rows("2 kHz haptic thread", busy, report);
  report.rows.push_back(measured("2 kHz haptic thread: computing time of one tick, p99.9", busy.work_us.p999(), "us"));
  report.notes.push_back(std::string("both threads run ") + (busy.realtime ? "with" : "without") +
                         " real-time priority and locked memory, in turns of 0.5 s");
  return {};
}

void measure_calibration(Report& report) {
  using namespace calibration;
  constexpr int kRegistrations = 2000;
  const auto by_covariance = registration_errors({}, RotationBy::Covariance, kRegistrations, 1);
  const auto as_printed = registration_errors({}, RotationBy::AffinePolar, kRegistrations, 1);
  report.rows.push_back(measured("calibration: error of one click, mean", by_covariance.noise.mean_m() * 1e3, "mm"));
  report.rows.push_back(
      measured("calibration: error of one click, standard deviation", by_covariance.noise.deviation_m() * 1e3, "mm"));
  report.rows.push_back(at_most("calibration: error at places without a click, mean",
                                by_covariance.at_targets.mean_m() * 1e3, "mm", 1.35));
  report.rows.push_back(at_most("calibration: error at places without a click, standard deviation",
                                by_covariance.at_targets.deviation_m() * 1e3, "mm", 0.58));
  report.rows.push_back(measured("calibration by the affine fit of paper S3: error at places without a click, mean",
                                 as_printed.at_targets.mean_m() * 1e3, "mm"));
  report.notes.push_back(
      "calibration: 8 places, 3 clicks each, 2000 random runs; paper S3 (section 4.2) reports 1.35 +- 0.58 mm");
}

}  // namespace

Result<Report> run_station(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 0.1, 3600.0);
  if (!seconds) return seconds.error();
  Report report{.bench = "station", .rows = {}, .notes = {}};
  if (const Result<void> done = measure_jitter(*seconds, report); !done) return done.error();
  measure_calibration(report);
  return report;
}

}  // namespace telepalp::bench
