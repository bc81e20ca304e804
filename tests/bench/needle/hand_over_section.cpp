#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/station/bill/thread_time.h"
#include "haptic_station/tissue/fem/prism_touch.h"
#include "tests/bench/distribution.h"
#include "tests/bench/needle/section.h"
#include "tests/haptic_station/tissue/fem/prism_runs.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using namespace std::chrono_literals;
using tissue::kTickOfPlane_s;

constexpr Nanoseconds kRun = 12ms;  // from the tool's place that a run of the slow stage is given to its hand-over

effects::FemPrismSettings prism() { return {.model = *tissue::make_prism_model({}), .slew = {}}; }

/// Forces of the prism that is computed anew in each tick of the pressing hand.
std::vector<Vector3d> true_forces_N() {
  tissue::PrismTouch truth(prism().model);
  std::vector<Vector3d> forces_N;
  for (int i = 0; i * kTickOfPlane_s < tissue::kPressing_s; ++i) {
    const Vector3d at_m = tissue::pressing_at(i * kTickOfPlane_s);
    const auto plane = truth.step(at_m, kTickOfPlane_s);
    forces_N.push_back(plane ? Vector3d(plane->force_N(at_m) * plane->normal)
                             : Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
  return forces_N;
}

void add_error(std::vector<Row>& rows) {
  const HandOverError error = hand_over_errors({kRun}).front();
  rows.push_back(
      at_most("hand-over: slow model at 62 Hz, a hand at up to 0.1 m/s: RMS error over the RMS force of the "
              "model at 2 kHz",
              error.percent, "%", 3.0));
  rows.push_back(measured("hand-over: greatest force of this hand", error.most_N, "N"));
}

/// A hand that presses and rubs for 20 s at changing speeds and places, with runs that are late now and then.
void add_energy(std::vector<Row>& rows) {
  device::Random random(3);
  tissue::PrismRun run(prism(), {0.03, 0.09, 0.0});
  Vector3d goal_m = run.at_m();
  double speed_m_per_s = 0.1;
  for (int i = 0; i < 40000; ++i) {
    if ((goal_m - run.at_m()).norm() < 1e-4) {
      goal_m = {random.uniform(0.0, 0.02), random.uniform(0.06, 0.105), random.uniform(-0.008, 0.008)};
      speed_m_per_s = random.uniform(0.01, 0.2);
    }
    const Vector3d way_m = goal_m - run.at_m();
    const double most_m = speed_m_per_s * kTickOfPlane_s;
    run.tick(run.at_m() + (way_m.norm() > most_m ? Vector3d(way_m * (most_m / way_m.norm())) : way_m),
             i % 8000 < 7000 ? kRun : 60ms);
  }
  constexpr double kRounding_J = 1e-12;  // of 40 000 sums
  const double unbooked_J = run.unbooked_J() < kRounding_J ? 0.0 : run.unbooked_J();
  rows.push_back(
      at_most("hand-over: energy that new models add and the tank does not book", 1e3 * unbooked_J, "mJ", 0.0));
  rows.push_back(at_least("hand-over: the tank's lowest level", 1e3 * run.least_tank_J(), "mJ", 0.0));
  rows.push_back(measured("hand-over: energy that all new models of this hand add", 1e3 * run.added_J(), "mJ"));
  rows.push_back(measured("hand-over: new models of this hand", run.handed_over(), ""));
  rows.push_back(at_most("hand-over: force step a tick beyond the spring's own", run.worst_step_N(), "N", 0.05));
}

/// The prism becomes a tenth stiffer under a hand that rests where a spring of 1400 N/m is 10 mm deep.
void add_stiffer(std::vector<Row>& rows) {
  tissue::HandOver hand({.held_s = 10.0});
  hand.begin({0.0, 0.0, 0.0});
  hand.plane.take(tissue::wall(1400, 0.0));
  hand.move({-0.01, 0.0, 0.0}, 0.1);
  hand.plane.take(tissue::wall(1540, 0.0));
  hand.rest(1.0);
  const double booked_J = hand.plane.tank().paid_J() - hand.plane.tank().filled_J();
  rows.push_back(measured("hand-over: 10 % more stiffness at 10 mm: energy that the tank books", 1e3 * booked_J, "mJ"));
}

/// Scenes without a prism, of which none may have the thread of a slow stage.
void add_others(std::vector<Row>& rows) {
  const auto folder = scenes::find_scene("palpation")->parent_path();
  std::size_t stages = 0;
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.path().filename().string().ends_with(".scene.textproto")) continue;
    const Result<scenes::Scene> scene = scenes::read_scene(entry.path());
    if (!scene || std::ranges::any_of(scene->effects, [](const effects::Recipe& recipe) {
          return std::holds_alternative<effects::FemPrismSettings>(recipe);
        }))
      continue;
    ++scenes;
    stages += core::build_effects(scene->effects).stages.size();
  }
  rows.push_back(
      at_most("hand-over: threads of slow stages in the library's other scenes, " + std::to_string(scenes) + " of them",
              static_cast<double>(stages), "", 0.0));
}

/// Time of the effect in a tick, while its prism is pressed.
void add_tick(std::vector<Row>& rows) {
  tissue::PrismRun run(prism(), tissue::pressing_at(0.0));
  Distribution taken_us;
  for (int i = 0; i * kTickOfPlane_s < 0.5 * tissue::kPressing_s; ++i) {
    run.tick(tissue::pressing_at(i * kTickOfPlane_s), kRun);
    effects::FemPrism effect = run.effect();
    effects::EffectInput in;
    in.device.m = run.at_m();
    constexpr int kSteps = 100;
    const std::int64_t before_ns = station::thread_ns();
    for (int k = 0; k < kSteps; ++k) (void)effect.step(in, kTickOfPlane_s);
    taken_us.add(1e-3 / kSteps * static_cast<double>(station::thread_ns() - before_ns));
  }
  rows.push_back(measured("hand-over: the effect in a tick, processor time: p50", taken_us.p50(), "us"));
  rows.push_back(measured("hand-over: the effect in a tick, processor time: p99", taken_us.p99(), "us"));
}

}  // namespace

std::vector<HandOverError> hand_over_errors(const std::vector<Nanoseconds>& costs) {
  static const std::vector<Vector3d> kTrue_N = true_forces_N();  // takes some seconds
  std::vector<HandOverError> errors;
  for (const Nanoseconds cost : costs) {
    tissue::PrismRun shown(prism(), tissue::pressing_at(0.0));
    HandOverError error;
    double error_N2 = 0.0;
    double true_N2 = 0.0;
    for (std::size_t i = 0; i < kTrue_N.size(); ++i) {
      shown.tick(tissue::pressing_at(static_cast<double>(i) * kTickOfPlane_s), cost);
      error_N2 += (shown.force_N() - kTrue_N[i]).squaredNorm();
      true_N2 += kTrue_N[i].squaredNorm();
      error.most_N = std::max(error.most_N, kTrue_N[i].norm());
    }
    error.percent = 100.0 * std::sqrt(error_N2 / true_N2);
    error.models_per_s = shown.handed_over() / tissue::kPressing_s;
    errors.push_back(error);
  }
  return errors;
}

std::vector<Row> run_needle_hand_over_section() {
  std::vector<Row> rows;
  add_error(rows);
  add_energy(rows);
  add_stiffer(rows);
  add_tick(rows);
  add_others(rows);
  return rows;
}

}  // namespace telepalp::bench
