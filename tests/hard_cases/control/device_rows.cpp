#include "proto/words/wrench.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/controller_scene.h"
#include "tests/hard_cases/control/loop_scene.h"
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
    // When the skin's force is below the limit, the device gives exactly this force.
    if (now_s > 110.0) cooled_N = std::max(cooled_N, out.force.N.norm());
    const double asked_N = 500.0 * out.indentation.v.norm();
    if (now_s > 60.0 && control::is_inside(out.phase) && asked_N < 3.9)
      wind_up_N = std::max(wind_up_N, std::abs(out.force.N.norm() - asked_N));
  };
  const Felt felt = feel(scene);
  return all_of({{limited, "limited"},
                 below_N("to what it may hold", hot_N, 4.05),
                 below_N("no wind-up: off the law, but for the vibration of the warning, by", wind_up_N, 0.15),
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

constexpr double kGlitch_s = 2.5;  // in contact

/// A hand that presses 30 mm deep and moves, with encoders that are off by `off_m(now_s)`.
struct WrongEncoders {
  Felt felt;
  double step_N = 0.0;  ///< largest change of force since the fault, without the part that the movement explains
  double least_balance_J = 0.0;  ///< least balance of the display's ledger since the fault
};
WrongEncoders with_encoders(const std::function<double(double)>& off_m, double seconds) {
  LoopScene scene;
  scene.effects = the_skin({.law = effects::linear_law(500.0)});
  scene.seconds = seconds;
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.03)(view);
    if (view.time_s > 1.5) aim.at.m.y() += 0.006 * std::sin(2.0 * std::numbers::pi * (view.time_s - 1.5));
    return aim;
  };
  scene.encoders = [&](double now_s, ports::DeviceReading& reading) { reading.at.m.y() += off_m(now_s); };
  WrongEncoders seen;
  Eigen::Vector3d before_N = Eigen::Vector3d::Zero();
  scene.watch = [&](const loop::TickOut& act, double now_s, const auto&, const auto&) {
    if (now_s > kGlitch_s - 0.001) {
      seen.step_N = std::max(seen.step_N, (act.force.N - before_N).norm());
      seen.least_balance_J = std::min(seen.least_balance_J, act.control.passivity_J);
    }
    before_N = act.force.N;
  };
  seen.felt = feel(scene);
  return seen;
}

AssertionResult encoder_glitch() {
  for (const double off_m : {0.0003, -0.0003, 0.002, -0.002}) {
    const WrongEncoders seen = with_encoders(
        [=](double now_s) { return now_s >= kGlitch_s && now_s < kGlitch_s + 0.0004 ? off_m : 0.0; }, 4.0);
    const AssertionResult result = all_of({below_N("step", seen.step_N, 0.1),
                                           below_mJ("the ledger's error", -seen.least_balance_J, 1.0),
                                           {!seen.felt.faulted && seen.felt.let_gos == 0, "contact holds"}});
    if (!result || off_m < -0.001) return result;
  }
  return ::testing::AssertionFailure() << "no glitch was tried";
}

AssertionResult encoder_offset() {
  const WrongEncoders seen = with_encoders([](double now_s) { return now_s >= kGlitch_s ? -0.03 : 0.0; }, 3.5);
  return all_of({{seen.felt.last.fault == control::FaultCause::DeviceImplausible, "a fault, latched"},
                 below_N("step", seen.step_N, 0.25),
                 {seen.felt.last.force.N.norm() == 0.0, "no force on an unknown place"}});
}

std::function<double(double)> no_number(double for_s, double number) {
  return [=](double now_s) { return now_s >= kGlitch_s && now_s < kGlitch_s + for_s - 1e-6 ? number : 0.0; };
}

AssertionResult no_number_for_16_ticks() {
  double step_N = 0.0;
  bool holds = true;
  for (const double number : {std::nan(""), HUGE_VAL})
    for (const int ticks : {1, 2, 16}) {
      const WrongEncoders seen = with_encoders(no_number(ticks * LoopScene::kTick_s, number), 4.0);
      step_N = std::max(step_N, seen.step_N);
      holds = holds && seen.felt.finite && !seen.felt.faulted && seen.felt.let_gos == 0;
    }
  return all_of({below_N("step", step_N, 0.05), {holds, "contact holds"}});
}

AssertionResult no_number_for_long() {
  WrongEncoders last;
  for (const int ticks : {17, 60, 600}) {
    last = with_encoders(no_number(ticks * LoopScene::kTick_s, std::nan("")), 4.5);
    const AssertionResult result =
        all_of({{last.felt.finite && !last.felt.faulted && last.felt.let_gos > 0, "let go, no fault"},
                below_N("step", last.step_N, 0.1),
                {control::is_inside(last.felt.last.phase), "felt again, without re-arming"}});
    if (!result) return result;
  }
  return all_of({below_N("step", last.step_N, 0.1), {!last.felt.faulted, "felt again, without re-arming"}});
}

/// The first number after the gap is 30 mm off, and so are all that follow.
AssertionResult no_number_then_an_offset() {
  const WrongEncoders seen = with_encoders(
      [](double now_s) {
        if (now_s < kGlitch_s) return 0.0;
        return now_s < kGlitch_s + 0.5 * LoopScene::kTick_s ? std::nan("") : -0.03;
      },
      3.5);
  return all_of({{seen.felt.last.fault == control::FaultCause::DeviceImplausible, "a fault, latched"},
                 below_N("step", seen.step_N, 0.25)});
}

/// A probe whose tip is 50 mm beside the device point presses on a membrane of 500 N/m, 20 mm under a soft skin. The
/// device states that it gives `most_N_m`.
struct Probing {
  Felt felt;
  double most_N_m = 0.0;  ///< largest torque
  double last_N_m = 0.0;  ///< at the end
  double step_N = 0.0;    ///< largest change of force in a tick since kGlitch_s
  double least_balance_J = 0.0;
  bool finite = true;
};
Probing probing(const std::function<void(double, ports::DeviceReading&)>& device) {
  LoopScene scene;
  scene.effects = the_skin({.law = effects::linear_law(20.0)});
  (void)scene.effects.add(effects::Membrane({.at = {{0.0, -0.02, 0.0}}, .tears_at_N = 1e9, .tip_m = {0.05, 0.0, 0.0}}));
  scene.seconds = 3.5;
  scene.person = presses_to(0.05);
  scene.encoders = device;
  Probing seen;
  Eigen::Vector3d before_N = Eigen::Vector3d::Zero();
  scene.watch = [&](const loop::TickOut& act, double now_s, const auto&, const auto&) {
    seen.finite = seen.finite && act.force.N.allFinite() && act.torque.N_m.allFinite();
    seen.last_N_m = act.torque.N_m.norm();
    seen.most_N_m = std::max(seen.most_N_m, seen.last_N_m);
    seen.least_balance_J = std::min(seen.least_balance_J, act.control.passivity_J);
    if (now_s > kGlitch_s - 0.001) seen.step_N = std::max(seen.step_N, (act.force.N - before_N).norm());
    before_N = act.force.N;
  };
  seen.felt = feel(scene);
  return seen;
}

Eigen::Quaterniond tilted(double rad) { return turned(Eigen::Quaterniond::Identity(), {0.0, 0.0, rad}); }

/// From kGlitch_s on, a device of six degrees answers in place of one of three, with its handle tilted by 0.8 rad:
/// down, 36 mm deeper into the membrane, or up.
AssertionResult from_three_to_six_degrees() {
  const auto replaced = [](double rad) {
    return probing([=](double now_s, ports::DeviceReading& reading) {
      if (now_s < kGlitch_s) return;
      reading.attitude = tilted(rad);
      reading.power = {.most_N = 10.0, .most_N_m = 0.5};
    });
  };
  const Probing down = replaced(-0.8);
  const Probing up = replaced(0.8);
  return all_of(
      {below_N("step, tilted into the membrane", down.step_N, 0.1),
       below_mJ("the ledger's error", -std::min(down.least_balance_J, up.least_balance_J), 1.0),
       {down.most_N_m == 0.0 && up.most_N_m == 0.0, "no torque until the next contact"},
       {!down.felt.faulted && !up.felt.faulted && control::is_inside(down.felt.last.phase), "contact holds"}});
}

AssertionResult attitude_that_is_no_rotation() {
  const double nan = std::nan("");
  Probing last;
  for (const Eigen::Quaterniond& wrong :
       {Eigen::Quaterniond(nan, nan, nan, nan), Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0)})
    for (const double until_s : {kGlitch_s + 0.004, 1e9}) {
      last = probing([=](double now_s, ports::DeviceReading& reading) {
        reading.attitude = now_s >= kGlitch_s && now_s < until_s ? wrong : tilted(0.0);
        reading.turning.v.x() = now_s >= kGlitch_s && now_s < until_s ? nan : 0.0;
        reading.power = {.most_N = 10.0, .most_N_m = 0.5};
      });
      const bool for_good = until_s > 1e6;
      const AssertionResult result =
          all_of({{last.finite && !last.felt.faulted, "no fault"},
                  {last.most_N_m > 0.1 && (for_good ? last.last_N_m == 0.0 : last.last_N_m > 0.1),
                   for_good ? "no torque at an unknown attitude" : "the torque goes on"},
                  below_N("step", last.step_N, 0.1)});
      if (!result) return result;
    }
  return all_of({below_N("step", last.step_N, 0.1), {last.finite, "every wrench is a number"}});
}

AssertionResult torque_above_the_devices() {
  const Probing seen = probing([](double, ports::DeviceReading& reading) {
    reading.attitude = tilted(0.0);
    reading.power = {.most_N = 10.0, .most_N_m = 0.05};
  });
  return all_of({{seen.most_N_m <= 0.05 && seen.most_N_m > 0.03, "most of its torque, and no more"},
                 {seen.felt.last.limited, "limited"},
                 below_mJ("the ledger's error", -seen.least_balance_J, 1.0),
                 {!seen.felt.faulted && seen.finite, "contact holds"}});
}

/// Encoders with steps of `step_m`, and the velocity that a device with a low-pass at 150 Hz reports from them.
class CoarseEncoders {
 public:
  explicit CoarseEncoders(double step_m) : step_m_(step_m) {}
  void operator()(double, ports::DeviceReading& reading) {
    constexpr double kShare = 0.376;  // of a new difference in the reported velocity: 1 - exp(-2 pi 150 Hz * 0.5 ms)
    reading.at.m = (reading.at.m / step_m_).array().round().matrix() * step_m_;
    if (begun_) speed_ += kShare * ((reading.at.m - before_m_) / LoopScene::kTick_s - speed_);
    before_m_ = reading.at.m;
    begun_ = true;
    reading.velocity.v = speed_;
  }

 private:
  double step_m_;
  Eigen::Vector3d before_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d speed_ = Eigen::Vector3d::Zero();
  bool begun_ = false;
};

/// Largest change of force in a tick of Body to plane outside the skin, 10 ms after a change of contact apart [N]. The
/// hand follows the lift and resists it. NaN: the lift was seen for less than a tenth of a second.
double lift_step_N(double encoder_step_m) {
  LoopScene scene;
  scene.effects = the_skin({.law = effects::linear_law(500.0)});
  scene.seconds = 6.0;
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.01)(view);
    if (view.time_s > 2.0) aim.at.m.y() = std::min(0.06, -0.01 + 0.03 * (view.time_s - 2.0));
    return aim;
  };
  scene.encoders = CoarseEncoders(encoder_step_m);
  double worst_N = 0.0, changed_s = 0.0;
  int lifted = 0;
  bool lifts = false;
  Eigen::Vector3d before_N = Eigen::Vector3d::Zero();
  scene.watch = [&](const loop::TickOut& act, double now_s, const auto&, const auto&) {
    const bool now = act.control.phase == Phase::BodyToPlane && !act.contact.in_body;
    if (now != lifts) changed_s = now_s;
    lifts = now;
    if (lifts && now_s - changed_s > 0.01) {
      worst_N = std::max(worst_N, (act.force.N - before_N).norm());
      ++lifted;
    }
    before_N = act.force.N;
  };
  (void)feel(scene);
  return lifted >= 200 ? worst_N : std::nan("");
}

AssertionResult coarse_encoders_in_the_lift() {
  const double fine_N = lift_step_N(0.13e-6);
  const double usual_N = std::max(lift_step_N(5e-6), lift_step_N(20e-6));
  const double coarse_N = lift_step_N(55e-6);
  const double coarsest_N = lift_step_N(100e-6);
  return all_of({below_N("step at 0.13 um", fine_N, 0.05), below_N("at 5 and 20 um", usual_N, 0.05),
                 below_N("at 55 um", coarse_N, 0.05), below_N("at 100 um", coarsest_N, 0.05)});
}

}  // namespace

std::vector<HardCase> device_rows() {
  return {
      {"device gives 2 N of 10", "less force than asked", "stable, contact holds", weak_motors},
      {"device hot after a minute", "the limiter holds 4 N of 9", "follows the law on release, no wind-up", hot_motors},
      {"device falls silent", "the device's position is unknown", "a fault until re-armed", silent_device},
      {"one encoder reading is off", "the force of a wrong position", "bridged: step 0.1 N, 1 mJ", encoder_glitch},
      {"encoders are off by 30 mm for good", "6.6 N within 10 ms", "held, then a fault", encoder_offset},
      {"3 degrees become 6 in a contact", "a handle 36 mm inside a membrane", "turns only where free, step 0.1 N",
       from_three_to_six_degrees},
      {"attitude is NaN, or of length zero", "its torque has no direction", "bridged, then no torque",
       attitude_that_is_no_rotation},
      {"0.25 N m asked of 0.05 N m", "cut alone, it would leak energy", "relaxed with the force",
       torque_above_the_devices},
      {"readings are no numbers for 16 ticks", "NaN spreads", "bridged: step 0.05 N", no_number_for_16_ticks},
      {"readings are no numbers for longer", "the place is unknown", "let go, resumes by itself", no_number_for_long},
      {"a reading is no number, the next is 30 mm off", "6.6 N within 10 ms", "held, then a fault",
       no_number_then_an_offset},
      {"encoders of 0.13 to 100 um under the lift", "a damper on a speed of steps", "step 0.05 N",
       coarse_encoders_in_the_lift},
      {"a number in the controller is NaN", "NaN spreads", "fault, finite force", device_that_is_no_number},
  };
}

}  // namespace telepalp::hard_cases
