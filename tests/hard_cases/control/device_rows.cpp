#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/controller_scene.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using control::Phase;
using ::testing::AssertionResult;

AssertionResult weak_motors() {
  ControllerScene scene;
  scene.settings.device.peak_N = 2.0;
  scene.person = presses_to(0.05);
  const Felt felt = feel(scene);
  return all_of({{felt.finite, "finite"},
                 below("stays slow", felt.fastest_device, 0.4, 1.0, "m/s"),
                 {control::is_inside(felt.last.phase), "contact holds"}});
}

/// A strong hand presses for a minute, which heats the motors to their limit, and then comes out slowly.
AssertionResult hot_motors() {
  ControllerScene scene = with_only(effects::Skin({.law = effects::linear_law(500.0)}));
  scene.seconds = 115.0;
  scene.settings.hand.stiffness_N_per_m = 1000.0;
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.03)(view);
    if (view.time_s > 60.0) aim.at.m.y() = std::min(0.06, -0.03 + 0.02 * (view.time_s - 60.0));
    if (view.time_s > 110.0) aim.at.m.y() = std::max(-0.03, 0.06 - 0.05 * (view.time_s - 110.0));
    return aim;
  };
  double hot_N = 0.0;
  double wind_up_N = 0.0;
  double cooled_N = 0.0;
  bool limited = false;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 50.0 && now_s < 60.0) hot_N = std::max(hot_N, out.force.N.norm());
    if (now_s > 50.0 && now_s < 60.0) limited = limited || out.limited;
    // Once the skin asks for less than the limit, it gets just that, at once.
    if (now_s > 110.0) cooled_N = std::max(cooled_N, out.force.N.norm());
    const double asked_N = 500.0 * out.indentation.v.norm();
    if (now_s > 60.0 && control::is_inside(out.phase) && asked_N < 3.9)
      wind_up_N = std::max(wind_up_N, std::abs(out.force.N.norm() - asked_N));
  };
  const Felt felt = feel(scene);
  return all_of({{limited, "limited"},
                 below_N("to what it may hold", hot_N, 4.05),
                 below_N("no wind-up: off the law by", wind_up_N, 0.05),
                 below_mJ("energy given", felt.energy_out_J, 1.0),
                 above("and more again when cool", cooled_N, 6.0, 1.0, "N")});
}

AssertionResult silent_device() {
  ControllerScene scene;
  scene.seconds = 6.0;
  scene.person = presses_to(0.03);
  scene.spoil = [](control::ControlInput& in, double now_s) {
    if (now_s > 2.5 && now_s < 3.0) in.device_age_s = now_s - 2.5;
    in.rearm = now_s > 4.0 && now_s < 4.001;
  };
  double faulted_N = 0.0;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 2.65 && now_s < 4.0) faulted_N = std::max(faulted_N, out.force.N.norm());
  };
  const Felt felt = feel(scene);
  return all_of({{felt.faulted, "a fault"},
                 {faulted_N == 0.0, "no force until re-armed, though it answers"},
                 below_N("step", felt.worst_step_N, 0.25),
                 {control::is_inside(felt.last.phase), "felt again when re-armed"}});
}

AssertionResult device_that_is_no_number() {
  ControllerScene scene;
  scene.person = presses_to(0.03);
  scene.spoil = [](control::ControlInput& in, double now_s) {
    if (now_s > 2.5 && now_s < 2.501) in.device.m.x() = std::nan("");
  };
  const Felt felt = feel(scene);
  return all_of({{felt.finite, "every force is a number"},
                 {felt.last.phase == Phase::Faulted && felt.last.fault == control::FaultCause::NotFinite, "latched"},
                 below_N("step", felt.worst_step_N, 0.25)});
}

}  // namespace

std::vector<HardCase> device_rows() {
  return {
      {"device gives 2 N of 10", "the force is not what was asked", "stable, contact holds", weak_motors},
      {"device hot after a minute", "the limiter holds 4 N of 9", "comes out by the law, no wind-up", hot_motors},
      {"device falls silent", "the force acts on an unknown place", "fault, latched until re-armed", silent_device},
      {"device that is no number", "NaN spreads", "fault, finite force", device_that_is_no_number},
  };
}

}  // namespace telepalp::hard_cases
