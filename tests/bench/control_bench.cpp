#include "tests/bench/control_bench.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>

#include "haptic_station/device/random.h"
#include "haptic_station/tracking/hand_trace.h"
#include "haptic_station/trials/blind_search.h"
#include "haptic_station/trials/trial_run.h"
#include "tests/bench/distribution.h"
#include "tests/bench/fixed_kalman.h"
#include "tests/bench/tick_times.h"
#include "where.h"

namespace telepalp::bench {
namespace {

void measure_tick(double seconds, Report& report) {
  effects::EffectBank bank;
  (void)bank.add(effects::Skin{});
  const TickTimes took = measure_ticks(bank, device::Trial::IndentSeveralPoints, seconds);
  report.rows.push_back(at_most("tick of a scene with skin alone: time, p50", took.all.p50(), "us", 5.0));
  report.rows.push_back(at_most("tick of a scene with skin alone: time, p99.9", took.all.p999(), "us", 50.0));
  report.rows.push_back(
      measured("tick of a scene with skin alone: processor time, p99.9", took.processor.p999(), "us"));
  report.rows.push_back(measured("tick in contact: time, p50", took.contact.p50(), "us"));
  report.rows.push_back(measured("number of ticks in contact", static_cast<double>(took.contact.count()), ""));
}

void run_trials(bool by_camera, Report& report) {
  const std::string on = by_camera ? ", skin as a camera sees it" : ", skin exactly known";
  trials::TrialFigures worst;
  int outer = 0;
  int inner = 0;
  for (const auto trial : {device::Trial::IndentSeveralPoints, device::Trial::MoveWithin, device::Trial::FindCylinder,
                           device::Trial::FreeSearch})
    for (const double breathing_m : {0.0, 0.005}) {
      const auto skin = by_camera ? trials::camera_skin({.breathing_m = breathing_m})
                                  : trials::level_skin({.amplitude_m = breathing_m});
      const auto result = trials::run_trial(trial, trials::paper_settings(), *skin);
      const trials::TrialFigures& f = result.figures;
      worst.worst_force_step_N = std::max(worst.worst_force_step_N, f.worst_force_step_N);
      worst.unfelt_s = std::max(worst.unfelt_s, f.unfelt_s);
      worst.worst_jump_m = std::max(worst.worst_jump_m, f.worst_jump_m);
      worst.worst_speed_jump_m_per_s = std::max(worst.worst_speed_jump_m_per_s, f.worst_speed_jump_m_per_s);
      worst.most_force_N = std::max(worst.most_force_N, f.most_force_N);
      worst.least_passivity_J = std::min(worst.least_passivity_J, f.least_passivity_J);
      bool all = true;
      for (const control::Phase phase :
           {control::Phase::InBody, control::Phase::BodyToPlane, control::Phase::OutBody, control::Phase::PlaneToBody})
        all = all && f.entered(phase) > 0;
      outer += all ? 1 : 0;
      if (trial == device::Trial::FindCylinder && f.entered(control::Phase::ObjectUpper) > 0 &&
          f.entered(control::Phase::ObjectLateral) > 0 && f.entered(control::Phase::AroundObject) > 0)
        ++inner;
    }
  report.rows.push_back(
      at_least("number of the 8 trial runs with all four phases of touching and leaving the skin" + on, outer, "", 8));
  report.rows.push_back(
      at_least("number of the 2 runs of the third trial with all three phases at the cylinder" + on, inner, "", 2));
  report.rows.push_back(
      at_most("largest jump of the end-effector at a change of phase" + on, worst.worst_jump_m * 1e3, "mm", 0.1));
  report.rows.push_back(at_most("largest jump of the end-effector's speed at a change of phase" + on,
                                worst.worst_speed_jump_m_per_s * 1e3, "mm/s", 20.0));
  report.rows.push_back(
      at_most("largest force step in one tick of the trials" + on, worst.worst_force_step_N, "N", 0.05));
  report.rows.push_back(at_most("time in a trial over 2 mm deep in the true skin without contact, worst" + on,
                                worst.unfelt_s * 1e3, "ms", 2.0));
  report.rows.push_back(at_most("largest force in the trials" + on, worst.most_force_N, "N", 10.0));
  report.rows.push_back(
      measured("lowest energy balance of the display in the trials" + on, worst.least_passivity_J * 1e3, "mJ"));
}

/// Worst relative error of the skin's force against eq. (6) to (8), straight and slanted, 1 to 60 mm deep.
void check_force_law(Report& report) {
  double worst = 0.0;
  for (const double slant : {0.0, 0.5, 1.0}) {
    effects::Skin skin;
    effects::EffectInput in;
    in.contact.normal.v = Eigen::Vector3d::UnitY();
    in.contact.valid = true;
    skin.begin(in);
    for (double depth_m = 0.001; depth_m <= 0.06; depth_m += 0.0005) {
      in.device.m = {slant * depth_m, -depth_m, 0.0};
      in.contact.proxy.m = {in.device.m.x(), 0.0, 0.0};
      const double d = in.device.m.norm();
      const Eigen::Vector3d expected_N = -(160.0 / 0.0636) * (d * d + d) * in.device.m;
      worst = std::max(worst, (skin.step(in, kTick_s).N - expected_N).norm() / expected_N.norm());
    }
  }
  report.rows.push_back(at_most("force law: largest relative error, 1 to 60 mm deep", worst * 100.0, "%", 0.5));
}

void search_for_cylinders(bool by_camera, int searches, Report& report) {
  const std::string on = by_camera ? ", skin as a camera sees it" : ", skin exactly known";
  int found = 0;
  int at_the_place = 0;
  int imagined = 0;
  int unfelt = 0;
  for (int i = 0; i < searches; ++i) {
    trials::BlindSearchSettings settings{.seed = static_cast<std::uint64_t>(i) + 1, .by_camera = by_camera};
    const auto with = trials::search_blindly(settings);
    settings.with_cylinder = false;
    const auto without = trials::search_blindly(settings);
    found += with.found ? 1 : 0;
    at_the_place += with.found && (with.where.m - with.cylinder.m).norm() < 0.03 ? 1 : 0;
    imagined += without.found || without.places_unfelt > 0 ? 1 : 0;
    unfelt += with.places_unfelt + without.places_unfelt;
  }
  const double percent = 100.0 / searches;
  report.rows.push_back(at_least("share of blind searches that find the cylinder under the skin by its force" + on,
                                 percent * found, "%", 95));
  report.rows.push_back(measured("share of blind searches that find the cylinder within 30 mm of its place" + on,
                                 percent * at_the_place, "%"));
  report.rows.push_back(
      at_most("share of blind searches without a cylinder that report one, or do not feel the skin at a place" + on,
              percent * imagined, "%", 5));
  report.rows.push_back(
      at_most("number of places in all blind searches at which the skin was not felt" + on, unfelt, "", 0));
}

/// Every other sample is held out and predicted from those before it.
struct PredictionError {
  double hold_m = 0.0;
  double line_m = 0.0;
  double fixed_m = 0.0;
  double estimate_m = 0.0;
};

PredictionError predict_held_out(const tracking::HandTrace& trace) {
  PredictionError sum;
  double count = 0.0;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    tracking::HandEstimate estimate;
    FixedKalman fixed(kFixedDamped);
    std::vector<const tracking::TraceSample*> used;
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
      const tracking::TraceSample& sample = trace.samples[i];
      if (i % 2 == parity) {
        (void)estimate.update(sample.at, {sample.palm.m});
        fixed.update(sample.at, sample.palm.m);
        used.push_back(&sample);
        continue;
      }
      if (used.size() < 5) continue;
      const tracking::TraceSample& last = *used.back();
      const tracking::TraceSample& before = *used[used.size() - 2];
      const double ahead_s = to_seconds(sample.at - last.at);
      const double span_s = to_seconds(last.at - before.at);
      if (ahead_s > 0.03 || span_s > 0.05) continue;  // the tracker had lost the hand
      const Eigen::Vector3d line = last.palm.m + (last.palm.m - before.palm.m) * (ahead_s / span_s);
      sum.hold_m += (last.palm.m - sample.palm.m).squaredNorm();
      sum.line_m += (line - sample.palm.m).squaredNorm();
      sum.fixed_m += (fixed.predict(sample.at) - sample.palm.m).squaredNorm();
      sum.estimate_m += (estimate.predict(sample.at).at.m - sample.palm.m).squaredNorm();
      count += 1.0;
    }
  }
  return {std::sqrt(sum.hold_m / count), std::sqrt(sum.line_m / count), std::sqrt(sum.fixed_m / count),
          std::sqrt(sum.estimate_m / count)};
}

Result<void> predict_hands(Report& report) {
  for (const std::string name : {"confidence-demo", "grab", "pinch", "test-paddle-rightwards"}) {
    const auto trace = tracking::read_hand_trace(TELEPALP_SOURCE_DIR "/tests/data/hand_tracking/" + name + ".csv");
    if (!trace) return trace.error();
    const PredictionError error = predict_held_out(*trace);
    report.rows.push_back(
        measured("hand prediction, recording " + name + ": last position held, RMSE", error.hold_m * 1e3, "mm"));
    report.rows.push_back(measured("hand prediction, recording " + name + ": straight line through two positions, RMSE",
                                   error.line_m * 1e3, "mm"));
    report.rows.push_back(
        measured("hand prediction, recording " + name + ": Kalman filter, fixed noise, damped velocity, RMSE",
                 error.fixed_m * 1e3, "mm"));
    report.rows.push_back(at_most("hand prediction, recording " + name + ": adaptive filter (default), RMSE",
                                  error.estimate_m * 1e3, "mm", std::min(error.hold_m, error.line_m) * 1e3));
  }
  return {};
}

void batter_limiter(Report& report) {
  device::Random random(20240);
  const control::ForceLimits limits;
  control::ForceLimiter limiter(limits);
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  double most_N = 0.0;
  double most_step_N = 0.0;
  const auto anything = [&random] {
    const std::uint64_t kind = random.bits() % 4;
    if (kind == 0) return std::bit_cast<double>(random.bits());
    if (kind == 1) return std::numeric_limits<double>::quiet_NaN();
    if (kind == 2) return std::numeric_limits<double>::infinity();
    return random.uniform(-30.0, 30.0);
  };
  Force<HapticBase> wanted;
  for (int i = 0; i < 1'000'000; ++i) {
    if (random.bits() % 4 == 0) limiter.rearm();
    // Each force is held for a while; otherwise the slew limit would keep the force below the peak.
    if (random.bits() % 30 == 0) wanted.N = {anything(), anything(), anything()};
    const Eigen::Vector3d given = limiter.limit({wanted}, kTick_s).force.N;
    most_N = given.allFinite() ? std::max(most_N, given.norm()) : std::numeric_limits<double>::infinity();
    most_step_N = std::max(most_step_N, (given - before).norm());
    before = given;
  }
  report.rows.push_back(
      at_most("force limiter, a million arbitrary inputs: largest force", most_N, "N", limits.peak_N));
  report.rows.push_back(at_most("force limiter: largest force step in one tick, divided by the slew limit's",
                                most_step_N / (limits.slew_N_per_s * kTick_s), "", 1.0 + 1e-9));
}

/// Longest time from an input's age limit to no force, over inputs and depths.
void time_watchdog(Report& report) {
  double worst_ms = 0.0;
  for (const int which : {1, 2})  // a lost hand releases the skin slowly; a hard case checks that
    for (const double depth_m : {0.01, 0.03, 0.06}) {
      effects::EffectBank bank;
      (void)bank.add(effects::Skin{});
      control::EncounteredController controller({}, bank);
      control::ControlInput in;
      const device::BreathingPlane skin;
      const auto ticks_at = [&](double y_m, int ticks) {
        for (int i = 0; i < ticks; ++i) {
          in.device.m.y() = in.hand.m.y() = y_m;
          in.hand_valid = true;
          in.contact = skin(in.device, 0.0);
          (void)controller.step(in, kTick_s);
        }
      };
      ticks_at(0.05, 2000);
      ticks_at(0.02, 1000);
      ticks_at(-depth_m, 5000);  // the sink-in rises at 0.03 m/s
      if (which == 1) in.contact.age_s = 1e9;
      if (which == 2) in.device_age_s = 1e9;
      int ticks = 0;
      while (controller.step(in, kTick_s).force.N.norm() > 0.0 && ticks < 10'000) ++ticks;
      worst_ms = std::max(worst_ms, ticks * kTick_s * 1e3);
    }
  report.rows.push_back(at_most("watchdog: time from an input's age limit to zero force, worst", worst_ms, "ms", 50.0));
}

}  // namespace

Result<Report> run_control(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 0.1, 3600.0);
  if (!seconds) return seconds.error();
  Report report{.bench = "control", .rows = {}, .notes = {}};
  measure_tick(*seconds, report);
  run_trials(false, report);
  run_trials(true, report);
  check_force_law(report);
  search_for_cylinders(false, 100, report);
  search_for_cylinders(true, 20, report);
  if (const Result<void> done = predict_hands(report); !done) return done.error();
  batter_limiter(report);
  time_watchdog(report);
  report.notes = {
      "trials and searches: virtual time, 2 kHz; skin still, or breathing 5 mm (searches: 3 mm) at 0.25 Hz",
      "hand prediction: every other position of a Leap Motion recording, predicted about 9 ms ahead from those before"};
  return report;
}

}  // namespace telepalp::bench
