#include <cmath>
#include <limits>

#include "haptic_station/device/random.h"
#include "haptic_station/loop/rig_tick.h"
#include "haptic_station/loop/simulated_rig.h"
#include "proto/words/clock_envelope.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/controller_scene.h"
#include "tests/hard_cases/control/forced_path.h"
#include "tests/hard_cases/control/loop_scene.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using control::Phase;
using ::testing::AssertionResult;

constexpr double kAt_s = 2.5;     // in contact
constexpr double kStep_N = 0.25;  // a fault fades the peak within 30 ms: the fastest change of force

/// A hand whose stamps are off by `off_s(now_s)`.
LoopScene with_tracker_stamps(const std::function<double(double)>& off_s) {
  LoopScene scene;
  scene.tracker = [=](int tick, double now_s, const Point<HapticBase>& hand) {
    return tick % LoopScene::kTicksPerSample == 0 ? std::vector<TrackedHand>{{now_s + off_s(now_s), hand}}
                                                  : std::vector<TrackedHand>{};
  };
  return scene;
}

/// A camera whose stamps are off by `off_s(now_s)`, and that is silent from `gone_s` on.
LoopScene with_camera_stamps(const std::function<double(double)>& off_s, double gone_s = 1e9) {
  LoopScene scene;
  scene.camera = [=](int tick, double now_s) {
    return tick % LoopScene::kTicksPerFrame == 0 && now_s < gone_s ? std::optional(SeenPlane{now_s + off_s(now_s)})
                                                                   : std::nullopt;
  };
  return scene;
}

/// `step_s` from kAt_s on, for half a second.
std::function<double(double)> off_for_half_a_second(double step_s) {
  return [=](double now_s) { return now_s > kAt_s && now_s < kAt_s + 0.5 ? step_s : 0.0; };
}

AssertionResult back_as_before(const Felt& felt, int let_gos) {
  return all_of({{felt.finite && !felt.faulted, "no fault"},
                 {felt.let_gos == let_gos, let_gos == 0 ? "no release" : "released once"},
                 below_N("step", felt.worst_step_N, kStep_N),
                 {control::is_inside(felt.last.phase), "felt again two seconds later"}});
}

AssertionResult tracker_steps_on() { return back_as_before(feel(with_tracker_stamps(off_for_half_a_second(1.0))), 0); }

AssertionResult tracker_steps_back() {
  return back_as_before(feel(with_tracker_stamps(off_for_half_a_second(-1.0))), 0);
}

AssertionResult one_stamp_an_hour_on() {
  return back_as_before(
      feel(with_tracker_stamps([](double now_s) { return now_s >= kAt_s && now_s < kAt_s + 0.0099 ? 3600.0 : 0.0; })),
      0);
}

/// The tracker's clock is set to another time. The mapping to session time (ClockEnvelope) follows.
AssertionResult trackers_clock_is_set() {
  for (const double step_s : {1.0, -1.0, -3600.0}) {
    ClockEnvelope envelope;
    LoopScene scene;
    scene.tracker = [&](int tick, double now_s, const Point<HapticBase>& hand) {
      if (tick % LoopScene::kTicksPerSample != 0) return std::vector<TrackedHand>{};
      const double theirs_s = 77.0 + now_s + (now_s > kAt_s ? step_s : 0.0);
      const auto ours = envelope.map(from_seconds(theirs_s), from_seconds(now_s));
      return std::vector<TrackedHand>{{to_seconds(ours), hand}};
    };
    if (const AssertionResult result = back_as_before(feel(scene), 0); !result) return result;
  }
  return back_as_before(feel(LoopScene{}), 0);
}

AssertionResult twice_and_out_of_order() {
  LoopScene scene;
  std::vector<TrackedHand> late;
  scene.tracker = [&](int tick, double now_s, const Point<HapticBase>& hand) {
    std::vector<TrackedHand> out;
    if (tick % LoopScene::kTicksPerSample != 0) return out;
    out = {{now_s, hand},
           {now_s, {hand.m + Eigen::Vector3d::UnitX()}}};  // the second sample has the same time and a wrong position
    out.insert(out.end(), late.begin(), late.end());
    late = {{now_s - 0.004, {hand.m - Eigen::Vector3d::UnitX()}}};
    return out;
  };
  double off_m = 0.0;
  scene.watch = [&](const auto& act, double, const auto&, const device::SimulatedPair& pair) {
    off_m = std::max(off_m, std::abs(act.sample.hand[0] - pair.true_hand().m.x()));
  };
  const Felt felt = feel(scene);
  return all_of({below_m("dropped: hand off by", off_m, 0.001),
                 {felt.let_gos == 0, "no release"},
                 below_N("step", felt.worst_step_N, 0.05)});
}

AssertionResult camera_steps_on() { return back_as_before(feel(with_camera_stamps(off_for_half_a_second(1.0))), 0); }

AssertionResult camera_steps_back() { return back_as_before(feel(with_camera_stamps(off_for_half_a_second(-1.0))), 1); }

/// The force from `from_s` on.
struct ForceFrom {
  Felt felt;
  double most_N = 0.0;
  double before_N = 0.0;
};
ForceFrom force_from(LoopScene scene, double from_s) {
  ForceFrom seen;
  scene.watch = [&](const loop::TickOut& act, double now_s, const auto&, const auto&) {
    (now_s < from_s ? seen.before_N : seen.most_N) =
        now_s < from_s ? act.force.N.norm() : std::max(seen.most_N, act.force.N.norm());
  };
  seen.felt = feel(scene);
  return seen;
}

/// The server's stamps are an hour ahead, and then it falls silent. Its last surface must not seem fresh for an hour.
AssertionResult from_the_future_then_silent() {
  LoopScene scene = with_camera_stamps([](double now_s) { return now_s > 2.0 ? 3600.0 : 0.0; }, 3.0);
  scene.seconds = 6.0;
  const ForceFrom seen = force_from(scene, 3.0 + 1.0 + 0.05);
  return all_of({{seen.most_N == 0.0, "no force 50 ms after the age limit"},
                 {seen.felt.last.phase == Phase::Released, "released"},
                 below_N("step", seen.felt.worst_step_N, kStep_N)});
}

/// Invalid ages, given directly to the controller.
AssertionResult ages_that_are_none() {
  ControllerScene scene;
  scene.seconds = 6.0;
  scene.person = presses_to(0.03);
  scene.spoil = [](control::ControlInput& in, double now_s) {
    if (now_s > 2.0 && now_s < 2.1) in.hand_age_s = -3600.0;
    if (now_s > 3.0 && now_s < 3.1) in.contact.age_s = std::nan("");
    if (now_s > 4.0 && now_s < 4.1) in.hand_age_s = std::numeric_limits<double>::infinity();
  };
  const Felt felt = feel(scene);
  return all_of(
      {{felt.finite, "finite"},
       {felt.let_gos + (felt.faulted ? 10 : 0) == 1, "the surface's age releases, the hand's for 0.1 s does not"},
       below_N("step", felt.worst_step_N, kStep_N)});
}

AssertionResult outage() {
  LoopScene scene = with_camera_stamps([](double) { return 0.0; }, 2.5);
  double at_half_s_N = 0.0;
  scene.watch = [&](const loop::TickOut& act, double now_s, const auto&, const auto&) {
    if (now_s < 3.0) at_half_s_N = act.force.N.norm();
  };
  (void)feel(scene);
  const ForceFrom seen = force_from(scene, 2.5 + 1.0 + 0.05);
  return all_of({above("half a second is bridged", at_half_s_N, 0.5, 1.0, "N"),
                 {seen.most_N == 0.0, "no force 50 ms after the age limit"},
                 below_N("step", seen.felt.worst_step_N, kStep_N)});
}

/// Stale until the hand is 10 ms above the skin. With the dwell, it would be 30 mm deep without a force.
AssertionResult back_above_the_skin() {
  constexpr double kSpeed_m_per_s = 0.2;
  constexpr double kMeets_s = 1.5 + 0.06 / kSpeed_m_per_s;
  ControllerScene scene;
  scene.seconds = 3.0;
  scene.person = falls_at(kSpeed_m_per_s);
  scene.spoil = [=](control::ControlInput& in, double now_s) {
    if (now_s > 1.0 && now_s < kMeets_s - 0.01) in.contact.age_s = 1.5;
  };
  double stale_N = 0.0;
  double begins_s = 1e9;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 1.06 && out.phase == Phase::Released) stale_N = std::max(stale_N, out.force.N.norm());
    if (control::is_inside(out.phase)) begins_s = std::min(begins_s, now_s);
  };
  const Felt felt = feel(scene);
  return all_of({{felt.let_gos == 1 && stale_N == 0.0, "no force on stale inputs"},
                 below("contact begins after", begins_s - kMeets_s, 0.1, 1e3, "ms"),
                 below_N("step", felt.worst_step_N, 0.05),
                 below_mJ("energy given", felt.energy_out_J, 1.0)});
}

/// Stale until the hand is 20 mm below the skin. With the dwell, no force would begin for another 0.3 s.
AssertionResult back_in_the_skin() {
  constexpr double kSpeed_m_per_s = 0.2;
  constexpr double kBack_s = 1.5 + 0.06 / kSpeed_m_per_s + 0.1;
  ControllerScene scene;
  scene.seconds = 3.0;
  scene.person = falls_at(kSpeed_m_per_s);
  scene.spoil = [=](control::ControlInput& in, double now_s) {
    if (now_s > 1.0 && now_s < kBack_s) in.contact.age_s = 1.5;
  };
  double stale_N = 0.0;
  double begins_s = 1e9;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 1.06 && out.phase == Phase::Released) stale_N = std::max(stale_N, out.force.N.norm());
    if (control::is_inside(out.phase)) begins_s = std::min(begins_s, now_s);
  };
  const Felt felt = feel(scene);
  return all_of({{felt.let_gos == 1 && stale_N == 0.0, "no force on stale inputs"},
                 below("contact begins after", begins_s - kBack_s, 0.1, 1e3, "ms"),
                 below_N("step", felt.worst_step_N, 0.05),
                 below_mJ("energy given", felt.energy_out_J, 1.0)});
}

/// Images stop at 0.5 s. The station releases the hand at 1.5 s. Without new images, the skin's coverage would reach 0
/// at 2 s. The hand enters the skin at 1.8 s, and goes on to a depth of 80 mm. The first new image comes at 1.9 s,
/// while the hand is 40 mm deep.
AssertionResult images_return_over_a_hand_in_the_skin() {
  LoopScene scene;
  scene.seconds = 4.0;
  scene.person = [](const device::TrialView& view) {
    const double in_m = 0.4 * std::max(0.0, view.time_s - 1.65);
    const double out_m = 0.2 * std::max(0.0, view.time_s - 2.6);
    return device::Intention{{{0.0, std::max(-0.08, 0.06 - in_m) + out_m, 0.0}}, {}};
  };
  scene.camera = [](int tick, double now_s) {
    const bool silent = now_s > 0.5 && now_s < 1.9;
    return tick % LoopScene::kTicksPerFrame == 0 && !silent ? std::optional(SeenPlane{now_s}) : std::nullopt;
  };
  double began_with = 0.0;
  double least_J = 0.0;
  scene.watch = [&](const loop::TickOut& act, double, const auto&, const auto&) {
    if (control::is_inside(act.control.phase) && !control::is_inside(act.control.previous))
      began_with = act.contact.coverage;
    least_J = std::min(least_J, act.control.passivity_J);
  };
  const Felt felt = feel(scene);
  return all_of({{felt.let_gos == 1 && felt.body_entries == 1, "released, and felt again"},
                 above("share of the skin as contact begins", began_with, 0.99, 100.0, "%"),
                 below_mJ("display's ledger below zero by", -least_J, 0.5),
                 below_N("step", felt.worst_step_N, 0.1)});
}

/// Good and stale inputs by turns of 50 ms, under a hand that goes in and out of the skin.
AssertionResult inputs_come_and_go() {
  const auto stale_at = [](double now_s) { return now_s > 1.0 && std::fmod(now_s, 0.1) < 0.05; };
  ForcedPath scene;
  scene.path = [](double since_down_s) -> Eigen::Vector3d { return {0.0, 0.03 * std::cos(8.0 * since_down_s), 0.0}; };
  scene.surface = [=](const Point<HapticBase>& device, double now_s) {
    ports::SurfaceContact contact = device::BreathingPlane{}(device, now_s);
    if (stale_at(now_s)) contact.age_s = 1.5;
    return contact;
  };
  bool begins_on_stale = false;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (stale_at(now_s) && control::is_inside(out.phase)) begins_on_stale = true;
  };
  const Felt felt = feel(scene);
  return all_of({{!begins_on_stale, "no contact on stale inputs"},
                 above("contacts", felt.body_entries, 3.0, 1.0, ""),
                 below_N("step", felt.worst_step_N, 0.1),
                 below_mJ("energy given", felt.energy_out_J, 5.0)});
}

/// A device that a hand moves up and down over the skin at up to 0.2 m/s, in true time.
class MovedDevice final : public ports::Rig {
 public:
  double time_s = 0.0;

  ports::DeviceReading read() noexcept override {
    return {.at = {{0.0, 0.02 * std::cos(10.0 * time_s), 0.0}}, .velocity = {}};
  }
  std::optional<ports::HandSample> hand(SessionTime now) noexcept override { return ports::HandSample{now, read().at}; }
  void apply(const Wrench<HapticBase>&, const ports::SurfaceContact&, double) noexcept override {}
};

/// A simulated device under a hand that goes in and out of the skin, as the demo has it.
loop::SimulatedRig simulated_device() {
  static const auto kWaypoints = [] {
    std::vector<device::Waypoint> out;
    for (int i = 0; i < 100; ++i)
      out.push_back({.seconds = 0.3, .x_m = 0.0, .height_m = i % 2 == 0 ? 0.05 : -0.02, .z_m = 0.0});
    return out;
  }();
  return {{.device = {}, .hand = {}, .tracker = {}, .rest = {{0.0, 0.05, 0.0}}},
          device::ScriptedIntention(kWaypoints, {})};
}

struct Busy {
  int faults = 0;
  int inside = 0;
  std::uint64_t jumps = 0;
};

/// `rig` on a computer whose other programs hold up the haptic thread: each eleventh tick on average is up to 6 ms
/// late, and each five-hundredth up to 0.3 s. `moves_to(s)` is called with the time of each tick.
template <class MovesTo>
Busy on_a_busy_computer(ports::Rig& rig, const MovesTo& moves_to) {
  loop::HapticLoop loop({}, control::EncounteredController({}, the_skin()));
  ShownSurface shown;
  device::Random random(7);
  Busy seen;
  double next_image_s = 0.0;
  for (std::uint64_t tick = 0; tick < 40'000; ++tick) {
    std::uint64_t missed = 0;
    if (random.uniform(0.0, 1.0) < 0.09) missed = static_cast<std::uint64_t>(random.uniform(1.0, 12.0));
    if (random.uniform(0.0, 1.0) < 0.002) missed = static_cast<std::uint64_t>(random.uniform(20.0, 600.0));
    tick += missed;
    const double now_s = static_cast<double>(tick) * LoopScene::kTick_s;
    moves_to(now_s);
    loop::TickIn due = loop::due_at(at_s(now_s), missed);
    if (now_s >= next_image_s) {
      auto newer = std::make_shared<loop::PlaneSnapshot>(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY(), 1.0);
      newer->captured = at_s(now_s);
      due.surface = shown.show({std::move(newer), {}});
      next_image_s = now_s + 0.033;
    }
    const loop::TickOut out = loop::tick_at_rig(
        loop, rig, due, [](const loop::TickIn&) {}, [](const loop::TickIn&, const loop::TickOut&) {});
    if (out.control.phase == Phase::Faulted) ++seen.faults;
    if (control::is_inside(out.control.phase)) ++seen.inside;
  }
  seen.jumps = loop.compensation().device_jumps;
  return seen;
}

AssertionResult thread_is_late() {
  loop::SimulatedRig simulated = simulated_device();
  MovedDevice moved;
  const Busy of_simulated = on_a_busy_computer(simulated, [](double) {});
  const Busy of_moved = on_a_busy_computer(moved, [&](double now_s) { moved.time_s = now_s; });
  const auto undisturbed = [](const Busy& one) {
    return all_of({{one.faults == 0, "no fault"},
                   below("readings taken for jumps", static_cast<double>(one.jumps), 0.5, 1.0, ""),
                   above("ticks in contact", one.inside, 3000.0, 1.0, "")});
  };
  const AssertionResult result = undisturbed(of_simulated);
  return result ? undisturbed(of_moved) : result;
}

}  // namespace

std::vector<HardCase> clock_rows() {
  return {
      {"20 tracker's stamps jump 1 s on", "stale samples would seem fresh", "the contact holds", tracker_steps_on},
      {"20 tracker's stamps jump 1 s back", "new samples seem older than known ones", "the contact holds",
       tracker_steps_back},
      {"20 one stamp an hour ahead", "all later samples seem older", "dropped, later samples are used",
       one_stamp_an_hour_on},
      {"20 tracker's clock is set", "by +1 s, -1 s and -1 h", "the clock mapping restarts", trackers_clock_is_set},
      {"20 samples twice, out of order", "two positions at one time: infinite speed", "dropped, nothing felt",
       twice_and_out_of_order},
      {"20 server's stamps jump 1 s on", "a stale surface would seem fresh", "held, then felt as before",
       camera_steps_on},
      {"20 server's stamps jump 1 s back", "new surfaces seem older than the limit", "released, then felt again",
       camera_steps_back},
      {"20 server from the future, then silent", "its last surface would seem fresh", "released at the age limit",
       from_the_future_then_silent},
      {"20 invalid ages", "minus an hour, NaN, infinity", "a bad surface age releases, a bad hand age not",
       ages_that_are_none},
      {"20 the haptic thread is late", "by up to 6 ms at each eleventh tick, and at times by 0.3 s",
       "the device's movement meanwhile is no jump and no fault", thread_is_late},
      {"24 outage in contact", "an old surface may be wrong", "the force decays to zero at the age limit", outage},
      {"24 inputs return as the hand meets the skin", "after a release the station waits for 0.3 s of good inputs",
       "contact begins at once, without a step", back_above_the_skin},
      {"24 inputs return when the hand is in the skin", "it came from outside, on stale inputs",
       "contact begins at once, without a step", back_in_the_skin},
      {"24 images return over a hand in the skin", "the skin that it passed had nearly faded",
       "the whole skin, from zero force on", images_return_over_a_hand_in_the_skin},
      {"24 good and stale inputs by turns", "each good turn could begin a contact, and each stale one ends it",
       "no force step above 0.1 N, no contact on stale inputs", inputs_come_and_go},
  };
}

}  // namespace telepalp::hard_cases
