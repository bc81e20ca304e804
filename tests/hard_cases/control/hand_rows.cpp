#include "haptic_station/device/random.h"
#include "tests/haptic_station/tracking/straight_on.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/controller_scene.h"
#include "tests/hard_cases/control/forced_path.h"
#include "tests/hard_cases/control/loop_scene.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using control::Phase;
using ::testing::AssertionResult;

AssertionResult drawn_away() {
  ControllerScene scene;
  scene.seconds = 6.0;
  scene.person = [](const device::TrialView& view) {
    return view.time_s < 2.5 ? presses_to(0.05)(view) : device::Intention{{{0.3, 0.3, 0.0}}, {}};
  };
  const Felt felt = feel(scene);
  return all_of({{felt.last.phase == Phase::OutBody, "ends waiting on the plane"},
                 below("does not fly off", felt.fastest_device, 1.2, 1.0, "m/s"),
                 below_N("step within the slew", felt.worst_step_N, 1.0)});
}

/// A browser's hand hovers over an end-effector that coasted into the body while the station gave no force.
AssertionResult let_go_below_a_hovering_hand() {
  ControllerScene scene;
  scene.seconds = 6.0;
  scene.device.m.y() = -0.06;
  scene.person = waits_at(0.12);
  bool entered = false;
  scene.spoil = [](control::ControlInput& in, double) { in.wait_at_m = 0.04; };
  scene.watch = [&](const control::ControlOutput& out, double) { entered = entered || is_inside(out.phase); };
  const Felt felt = feel(scene);
  return all_of({{!entered, "is lifted out of the body without a contact"},
                 {felt.last.phase == Phase::OutBody, "ends waiting above the skin"},
                 below_N("step within the slew", felt.worst_step_N, 1.0)});
}

/// Figures of a contact from `lost_s` on.
struct LettingGo {
  Felt felt;
  double before_N = 0.0;
  double after_limit_N = 0.0;  ///< force after the time of the release, while the hand is lost
  double step_N = 0.0;
  double fell_m = 0.0;           ///< farthest movement of the hand while it was lost
  double fastest_m_per_s = 0.0;  ///< largest speed of the hand while it was lost
};

LettingGo tracker_lost_in_contact(double lost_s, double back_s, Person person) {
  LoopScene scene;
  LettingGo seen;
  scene.seconds = back_s + 3.0;
  scene.person = std::move(person);
  scene.tracker = [=](int tick, double now_s, const Point<HapticBase>& hand) {
    const bool lost = now_s > lost_s && now_s < back_s;
    return tick % LoopScene::kTicksPerSample == 0 && !lost ? std::vector<TrackedHand>{{now_s, hand}}
                                                           : std::vector<TrackedHand>{};
  };
  Eigen::Vector3d before_N = Eigen::Vector3d::Zero();
  const double let_go_s =
      lost_s + control::AgeLimits{}.tracker_in_contact_s + control::TransitionSettings{}.contact_release_s + 0.05;
  double height_m = 0.0;
  scene.watch = [&, let_go_s](const loop::TickOut& act, double now_s, const auto&, const device::SimulatedPair& pair) {
    if (now_s <= lost_s) seen.before_N = act.force.N.norm();
    if (now_s <= lost_s) height_m = pair.true_hand().m.y();
    if (now_s > lost_s) seen.step_N = std::max(seen.step_N, (act.force.N - before_N).norm());
    if (now_s > let_go_s && now_s < back_s) seen.after_limit_N = std::max(seen.after_limit_N, act.force.N.norm());
    if (now_s > lost_s && now_s < back_s) {
      seen.fell_m = std::max(seen.fell_m, std::abs(pair.true_hand().m.y() - height_m));
      seen.fastest_m_per_s = std::max(seen.fastest_m_per_s, pair.true_hand_velocity().v.norm());
    }
    before_N = act.force.N;
  };
  seen.felt = feel(scene);
  return seen;
}

AssertionResult tracker_loses_it() {
  const LettingGo seen = tracker_lost_in_contact(2.5, 9.0, presses_to(0.05));
  return all_of({above("from", seen.before_N, 2.0, 1.0, "N"),
                 {seen.after_limit_N == 0.0, "none after 3 s and a release of 2 s"},
                 below_N("gently: step", seen.step_N, 0.05),
                 below("the hand does not fall", seen.fastest_m_per_s, 0.05, 1e3, "mm/s"),
                 {seen.felt.let_gos == 1 && !seen.felt.faulted, "released once, no fault"},
                 {control::is_inside(seen.felt.last.phase), "and felt again when it is back"}});
}

AssertionResult tracker_silent_for_half_a_second() {
  const LettingGo seen = tracker_lost_in_contact(2.5, 3.0, presses_to(0.05));
  return all_of({above("from", seen.before_N, 2.0, 1.0, "N"),
                 below("the hand stays", seen.fell_m, 0.003, 1e3, "mm"),
                 {seen.felt.let_gos == 0, "nothing is let go"}});
}

/// The hand leaves the skin. Just when Out body begins, it comes back at 0.8 m/s.
AssertionResult back_as_out_body_begins() {
  constexpr double kSkin_N_per_m = 500.0;
  ControllerScene scene = with_only(effects::Skin({.law = effects::linear_law(kSkin_N_per_m)}));
  scene.seconds = 5.0;
  double out_s = 1e9;
  double depth_m = 0.0;
  double unfelt_s = 0.0;
  double unfelt_m = 0.0;
  scene.person = [&](const device::TrialView& view) {
    device::Intention aim = presses_to(0.02)(view);
    if (view.time_s > 2.5) aim.at.m.y() = std::min(0.06, -0.02 + 0.2 * (view.time_s - 2.5));
    if (view.time_s > out_s) aim.at.m.y() = std::max(-0.04, 0.06 - 0.8 * (view.time_s - out_s));
    return aim;
  };
  scene.surface = [&](const Point<HapticBase>& device, double time_s) {
    depth_m = -device.m.y();
    return device::BreathingPlane{}(device, time_s);
  };
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 2.5 && out_s > now_s && out.phase == Phase::OutBody) out_s = now_s;
    const bool felt = out.force.N.y() >= 0.5 * std::min(10.0, kSkin_N_per_m * depth_m) && control::is_inside(out.phase);
    if (now_s < out_s || depth_m < 0.0005 || felt) return;
    unfelt_s += 0.0005;
    unfelt_m = std::max(unfelt_m, depth_m);
  };
  const Felt felt = feel(scene);
  return all_of({{out_s < 5.0 && control::is_inside(felt.last.phase), "out, and back in the body"},
                 below("unfelt for", unfelt_s, 0.002, 1e3, "ms"),
                 below("unfelt to", unfelt_m, 0.002, 1e3, "mm")});
}

AssertionResult tracker_blinks() {
  const LettingGo seen = tracker_lost_in_contact(2.5, 2.58, rubs_at(0.05, 0.02));
  return all_of({{seen.felt.let_gos == 0, "80 ms without a hand let nothing go"}, below_N("step", seen.step_N, 0.05)});
}

/// The tracker reports another hand 0.3 m away while `swapped(now_s)` is true.
Felt with_swapped_hands(Person person, const std::function<bool(double)>& swapped, double& shown_m) {
  LoopScene scene;
  scene.person = std::move(person);
  scene.rearms = [](double now_s) { return now_s > 3.0 && now_s < 3.001; };
  scene.tracker = [&](int tick, double now_s, const Point<HapticBase>& hand) {
    if (tick % LoopScene::kTicksPerSample != 0) return std::vector<TrackedHand>{};
    return std::vector<TrackedHand>{{now_s, {hand.m + (swapped(now_s) ? 0.3 : 0.0) * Eigen::Vector3d::UnitX()}}};
  };
  scene.watch = [&](const loop::TickOut& act, double, const auto&, const device::SimulatedPair& pair) {
    shown_m = std::max(shown_m, std::abs(act.sample.hand[0] - pair.true_hand().m.x()));
  };
  return feel(scene);
}

AssertionResult swapped_for_a_moment() {
  double off_m = 0.0;
  const Felt felt = with_swapped_hands(
      waits_at(0.06), [](double t) { return t > 1.0 && std::fmod(t, 0.5) < 0.03; }, off_m);
  return all_of({below_m("three samples of another hand are not believed: off by", off_m, 0.005),
                 below_N("step", felt.worst_step_N, 0.05)});
}

AssertionResult swapped_for_good() {
  double off_m = 0.0;
  const Felt felt = with_swapped_hands(
      waits_at(0.06), [](double t) { return t > 2.0; }, off_m);
  return all_of({{felt.faulted, "held, then a fault"},
                 above("believed after half a second", off_m, 0.29, 1e3, "mm"),
                 {felt.last.phase == Phase::OutBody, "re-armed, it follows"},
                 below("the device is not thrown", felt.fastest_device, 2.0, 1.0, "m/s"),
                 below_N("step", felt.worst_step_N, 0.25),
                 {felt.most_N <= 3.0 + 1e-9, "a hand can hold it"}});
}

/// A tracker without a hold on the hand: it is here, there and elsewhere.
AssertionResult jumps_that_last() {
  LoopScene scene;
  scene.person = waits_at(0.06);
  scene.seconds = 4.0;
  scene.tracker = [](int tick, double now_s, const Point<HapticBase>& hand) {
    if (tick % LoopScene::kTicksPerSample != 0) return std::vector<TrackedHand>{};
    const double off_m = now_s > 2.0 ? (tick % (2 * LoopScene::kTicksPerSample) == 0 ? 0.4 : -0.4) : 0.0;
    return std::vector<TrackedHand>{{now_s, {hand.m + off_m * Eigen::Vector3d::UnitX()}}};
  };
  double faulted_s = 9.0;
  double off_m = 0.0;
  std::uint64_t counted = 0;
  scene.watch = [&](const loop::TickOut& act, double now_s, const loop::HapticLoop& loop,
                    const device::SimulatedPair& pair) {
    if (act.control.phase == Phase::Faulted) faulted_s = std::min(faulted_s, now_s);
    off_m = std::max(off_m, std::abs(act.sample.hand[0] - pair.true_hand().m.x()));
    counted = loop.compensation().hand_jumps;
  };
  const Felt felt = feel(scene);
  return all_of({below("a fault after", faulted_s - 2.0, 0.1, 1e3, "ms"),
                 {felt.last.fault == control::FaultCause::HandImplausible, "latched"},
                 {counted >= 190, "counted"},
                 below_m("never believed: off by", off_m, 0.005),
                 below_N("step", felt.worst_step_N, 0.25)});
}

AssertionResult hands_swapped_in_contact() {
  double off_m = 0.0;
  const Felt felt = with_swapped_hands(
      presses_to(0.03), [](double t) { return t > 2.5; }, off_m);
  return all_of({below_N("the skin feels nothing of it: step", felt.worst_step_N, 0.05),
                 {felt.body_entries == 1 && control::is_inside(felt.last.phase), "contact holds"}});
}

AssertionResult jittered() {
  LoopScene scene;
  device::Random random(21);
  double next_s = 0.0;
  std::vector<TrackedHand> held;
  scene.seconds = 12.0;
  scene.person = [](const device::TrialView& view) {  // sideways over the plane, as fast as hands search
    return device::Intention{{{0.1 * std::sin(2.0 * view.time_s), 0.06, 0.0}}, {}};
  };
  scene.tracker = [&](int, double now_s, const Point<HapticBase>& hand) {
    std::vector<TrackedHand> out;
    if (now_s >= next_s) {
      next_s = now_s + 0.01 + random.uniform(-0.005, 0.005);
      if (random.uniform(0.0, 1.0) < 0.05) next_s += 0.05;  // a gap
      held.push_back({now_s - random.uniform(0.0, 0.004), hand});
    }
    const bool flush = (!held.empty() && now_s - held.front().at_s > 0.025) ||
                       random.uniform(0.0, 1.0) < 0.05;  // bursts: several late samples at once
    if (flush) out.swap(held);
    return out;
  };
  double sigma_m = 0.0;
  double error_m = 0.0;
  scene.watch = [&](const loop::TickOut& act, double now_s, const loop::HapticLoop& loop,
                    const device::SimulatedPair& pair) {
    if (now_s < 1.0) return;
    sigma_m = std::max(sigma_m, loop.compensation().hand_sigma_m);
    error_m = std::max(error_m, std::abs(act.sample.hand[0] - pair.true_hand().m.x()));
  };
  const Felt felt = feel(scene);
  return all_of({below("covariance bounded: sigma", sigma_m, 0.02, 1e3, "mm"),
                 below("off by", error_m, 0.03, 1e3, "mm"),
                 below_N("step", felt.worst_step_N, 0.05),
                 {felt.let_gos == 0, "nothing let go"}});
}

AssertionResult predicted_from_any_tracker() {
  double worst = 0.0;
  for (const auto& file : testing::recorded_hands()) {
    const auto trace = tracking::read_hand_trace(file);
    if (!trace) return ::testing::AssertionFailure() << to_string(trace.error());
    for (const double noise_m : {0.0, 0.001})
      for (const std::size_t every : {1U, 2U})
        worst = std::max(worst, testing::worst_ratio_to_straight_on(*trace, every, noise_m));
  }
  return all_of({below("error over straight-on, worst of 20", worst, 1.02, 1.0, "")});
}

AssertionResult too_fast_for_the_dwell() {
  ControllerScene scene;
  scene.seconds = 3.0;
  scene.person = falls_at(1.5, 0.1);
  double crossed_s = 0.0;
  double felt_s = 0.0;
  scene.surface = [&](const Point<HapticBase>& device, double time_s) {
    if (crossed_s == 0.0 && device.m.y() < 0.0) crossed_s = time_s;
    return device::BreathingPlane{}(device, time_s);
  };
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (felt_s == 0.0 && control::is_inside(out.phase)) felt_s = now_s;
  };
  const Felt felt = feel(scene);
  return all_of({{crossed_s > 0.0 && felt_s > 0.0, "it falls through"},
                 below("felt at once, not 0.3 s late", felt_s - crossed_s, 0.001, 1e3, "ms"),
                 {felt.most_N <= 10.0, "below the peak"},
                 {control::is_inside(felt.last.phase), "in the body"}});
}

/// The hand leaves the skin, the lift takes the end-effector, and right then the hand comes back.
AssertionResult back_in_the_lift() {
  ControllerScene scene;
  scene.seconds = 5.0;
  double lifted_s = 1e9;
  int late_ticks = 0;
  scene.person = [&](const device::TrialView& view) {
    device::Intention aim = presses_to(0.02)(view);
    if (view.time_s > 2.5) aim.at.m.y() = std::min(0.06, -0.02 + 0.2 * (view.time_s - 2.5));
    if (view.time_s > lifted_s + 0.05) aim.at.m.y() = -0.03;
    return aim;
  };
  bool in_body = false;
  scene.spoil = [&](control::ControlInput& in, double) { in_body = in.contact.in_body; };
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 2.5 && out.phase == Phase::BodyToPlane) lifted_s = std::min(lifted_s, now_s);
    if (now_s > 2.5 && in_body && !control::is_inside(out.phase)) ++late_ticks;
  };
  const Felt felt = feel(scene);
  return all_of({{lifted_s < 5.0 && control::is_inside(felt.last.phase), "lifted, and back in the body"},
                 below("ticks in the skin and not In body", late_ticks, 0.5, 1.0, "")});
}

/// Forced through the skin 40 times a second, at 2 m/s.
AssertionResult chatters() {
  ForcedPath scene;
  scene.seconds = 22.0;
  scene.path = [](double since_down_s) -> Eigen::Vector3d {
    constexpr double kOmega = 2.0 * std::numbers::pi * 20.0;
    return 2.0 / kOmega * std::sin(kOmega * since_down_s) * Eigen::Vector3d::UnitY();
  };
  double entered_s = 0.0;
  double shortest_s = 1.0;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (out.phase == out.previous) return;
    // A change into the body may follow another change at once.
    if (!control::is_inside(out.phase)) shortest_s = std::min(shortest_s, now_s - entered_s);
    entered_s = now_s;
  };
  const Felt felt = feel(scene);
  return all_of({above("shortest stay", shortest_s, 0.2995 - 1e-9, 1e3, "ms"),
                 below("changes at 800 crossings", felt.changes, 2.0 * 20.0 / 0.3 + 5.0, 1.0, ""),
                 {felt.finite && !felt.faulted, "no fault"},
                 below_N("force", felt.most_N, 10.0)});
}

/// Duration of the phase In body [s], for a hand that touches the skin for 20 ms, leaves it at 2 m/s, and is `away_m`
/// above the skin when the dwell ends.
double in_body_s(double away_m) {
  constexpr double kDepth_m = 0.0005;
  ForcedPath scene;
  scene.seconds = ForcedPath::kDown_s + 1.0;
  scene.path = [=](double since_down_s) -> Eigen::Vector3d {
    return std::min(away_m, 2.0 * since_down_s - kDepth_m) * Eigen::Vector3d::UnitY();
  };
  double begun_s = INFINITY;
  double ended_s = INFINITY;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (control::is_inside(out.phase)) begun_s = std::min(begun_s, now_s);
    if (now_s > begun_s && out.phase == Phase::BodyToPlane) ended_s = std::min(ended_s, now_s);
  };
  (void)feel(scene);
  return ended_s - begun_s;
}

/// The phase In body lasts equally long, however far the hand goes. In S1, it ends only within d_thr of the skin.
AssertionResult leaves_at_any_distance() {
  const double near_s = in_body_s(0.001);
  double apart_s = 0.0;
  for (const double away_m : {0.01, 0.05, 0.5}) apart_s = std::max(apart_s, std::abs(in_body_s(away_m) - near_s));
  return all_of({above("1 mm away, after the dwell", near_s, 0.2995 - 1e-9, 1e3, "ms"),
                 below("and not later", near_s, 0.3015, 1e3, "ms"),
                 below("to 500 mm away, apart by", apart_s, 1e-9, 1e3, "ms")});
}

}  // namespace

std::vector<HardCase> hand_rows() {
  return {
      {"hand drawn away in contact", "no hand resists the skin's push", "does not fly off, waits on the plane",
       drawn_away},
      {"browser's hand hovers over a device let go below the skin", "the lift takes it through the skin from below",
       "lifted out without a contact", let_go_below_a_hovering_hand},
      {"hand leaves the skin by 1 mm to 500 mm", "S1 goes on only within d_thr of the skin",
       "the next phase on the same tick at any distance", leaves_at_any_distance},
      {"hand comes back as Out body begins", "the dwell would last 0.3 s", "felt within 2 ms and 2 mm",
       back_as_out_body_begins},
      {"tracker silent for 0.5 s in contact", "the skin's force needs no tracker", "the hand stays",
       tracker_silent_for_half_a_second},
      {"tracker loses the hand in contact", "force without a tracked hand", "slow release, felt again when back",
       tracker_loses_it},
      {"tracker blinks in contact", "no sample for 80 of 100 ms", "no release", tracker_blinks},
      {"tracker swaps hands for a moment", "the pose jumps 0.3 m and back", "rejected, no step", swapped_for_a_moment},
      {"tracker swaps hands for good", "the pose jumps 0.3 m and stays",
       "held, a fault; re-armed, followed at a bounded speed", swapped_for_good},
      {"tracker jumps about", "no sample can follow from the one before", "held, counted, then a fault",
       jumps_that_last},
      {"tracker swaps hands in contact", "the pose jumps 0.3 m while pressing", "the skin feels nothing of it",
       hands_swapped_in_contact},
      {"21 jitter, gaps and bursts", "wrong intervals give wrong speeds", "covariance bounded, no step", jittered},
      {"tracker that smooths, tracker with noise", "the noise that a filter expects is wrong for one of them",
       "never worse than straight-on, 5 to 50 ms ahead", predicted_from_any_tracker},
      {"fast hand against the dwell", "in 0.3 s it would be through the patient", "contact does not wait for the dwell",
       too_fast_for_the_dwell},
      {"hand comes back in the lift", "the dwell would last 0.3 s", "In body on the tick that it meets the skin",
       back_in_the_lift},
      {"hand chatters at 20 Hz, 2 m/s", "two phases could alternate", "at least 0.3 s in the body", chatters},
  };
}

}  // namespace telepalp::hard_cases
