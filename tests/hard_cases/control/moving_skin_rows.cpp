#include <numbers>

#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/moving_skin.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using ::testing::AssertionResult;

constexpr double kTau = 2.0 * std::numbers::pi;

/// The sliding skin, a hand that presses 20 mm deep, and a patient who steps by 10 mm at 3 s.
AssertionResult step_by_10_mm() {
  double worst_N = 0.0;
  double slowest_s = 0.0;
  for (const double hz : {10.0, 30.0, 100.0, 200.0})
    for (const double step_m : {0.01, -0.01}) {
      MovingSkinScene scene;
      scene.frames_hz = hz;
      scene.effects = the_skin({.law = effects::linear_law(300.0), .anchor = effects::SkinAnchor::Sliding});
      scene.skin = [=](double now_s) { return MovingSkin::Shape{.flat_m = now_s < 3.0 ? 0.0 : step_m}; };
      double last_N = 0.0;
      double reached_s = 1e9;
      scene.watch = [&](const loop::TickOut& act, double now_s) {
        const double force_N = act.force.N.norm();
        if (now_s > 2.5) worst_N = std::max(worst_N, std::abs(force_N - last_N));
        last_N = force_N;
        if (act.contact.proxy.m.y() / step_m >= 0.9) reached_s = std::min(reached_s, now_s - 3.0);
      };
      (void)feel(scene);
      slowest_s = std::max(slowest_s, reached_s);
    }
  return all_of({below_N("step", worst_N, 0.1), below("90 % at 10 to 200 Hz", slowest_s, 0.6, 1.0, "s")});
}

/// A delay of 0.15 s. The patient sinks by 10 mm at 3 s, and the hand lets go 0.05 s later, before any image shows it.
AssertionResult let_go_as_it_sinks() {
  constexpr double kSkin_N_per_m = 300.0;
  MovingSkinScene scene;
  scene.delay_s = 0.15;
  scene.effects = the_skin({.law = effects::linear_law(kSkin_N_per_m), .anchor = effects::SkinAnchor::Sliding});
  const auto skin_m = [](double now_s) { return now_s < 3.0 ? 0.0 : -0.01; };
  scene.skin = [=](double now_s) { return MovingSkin::Shape{.flat_m = skin_m(now_s)}; };
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.03)(view);
    aim.at.m.y() += 0.1 * std::clamp((view.time_s - 3.05) / 0.5, 0.0, 1.0);
    return aim;
  };
  double excess_J = 0.0, seen_J = 0.0, deepest_m = 0.0, last_m = 0.05, force_N = 0.0, law_N = 0.0;
  scene.watch = [&](const loop::TickOut& act, double now_s) {
    const double device_m = act.sample.device[1];
    excess_J += (force_N - law_N) * (device_m - last_m);
    last_m = device_m;
    force_N = control::is_inside(act.control.phase) ? act.force.N.y() : 0.0;
    law_N = kSkin_N_per_m * std::max(0.0, skin_m(now_s) - device_m);
    if (now_s < 3.0) deepest_m = std::max(deepest_m, -device_m);
    if (control::is_inside(act.control.phase)) seen_J = act.control.hand_excess_J;
  };
  const Felt felt = feel(scene);
  // The energy that the hand put into the skin's spring before it sank, minus the energy in the spring after it sank.
  const double above_m = std::max(0.0, deepest_m - 0.01);
  const double stored_J = 0.5 * kSkin_N_per_m * (deepest_m * deepest_m - above_m * above_m);
  return all_of({above("the hand had stored", stored_J, 0.001, 1e3, "mJ"),
                 below("given to it beyond the true skin, of that", excess_J / stored_J, 1.05, 100.0, "%"),
                 below_mJ("the station's ledger saw", std::abs(seen_J), 3.0), below_N("step", felt.worst_step_N, 0.1)});
}

/// A skin with a hinge at x = 0. It breathes by 10 mm at x = 40 mm, where the contact began, and the hand rubs 20 mm to
/// either side in step with the breath.
AssertionResult rubbed_in_step_with_the_breath() {
  MovingSkinScene scene;
  scene.seconds = 66.0;
  scene.skin = [](double now_s) {
    const double phase = kTau * 0.25 * now_s;
    return MovingSkin::Shape{.per_m = 0.25 * std::sin(phase), .turns_per_s = 0.25 * kTau * 0.25 * std::cos(phase)};
  };
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.04, 0.04)(view);
    const double rubs = std::clamp(view.time_s - 4.0, 0.0, 1.0);
    aim.at.m.x() += rubs * 0.02 * std::cos(kTau * 0.25 * view.time_s);
    aim.at.m.y() += aim.at.m.x() * 0.25 * std::sin(kTau * 0.25 * view.time_s);  // goes with the skin
    return aim;
  };
  double first_x_m = 0.0;
  double worst_m = 0.0;
  bool touched = false;
  scene.watch = [&](const loop::TickOut& act, double now_s) {
    if (!control::is_inside(act.control.phase)) return;
    if (!std::exchange(touched, true)) first_x_m = act.contact.proxy.m.x();
    if (now_s < 60.0) return;
    // The default skin's d starts at its anchor, which should lie on the true skin at the x of the first contact.
    const Eigen::Vector3f device(act.sample.device.data());
    const Eigen::Vector3d anchor = device.cast<double>() - act.control.indentation.v;
    worst_m = std::max(worst_m, std::abs(anchor.y() - anchor.x() * 0.25 * std::sin(kTau * 0.25 * now_s)));
  };
  const Felt felt = feel(scene);
  return all_of({{touched && felt.body_entries == 1, "one contact"},
                 below("anchor off the skin after 60 s", worst_m, 0.001, 1e3, "mm"),
                 below_N("step", felt.worst_step_N, 0.05)});
}

/// The default skin, and a surface that ends where the hand rubs to.
AssertionResult off_the_rim() {
  MovingSkinScene scene;
  scene.seconds = 6.0;
  scene.skin = [](double) { return MovingSkin::Shape{.ends_at_x_m = 0.02}; };
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.03)(view);
    aim.at.m.x() += std::clamp(0.02 * (view.time_s - 2.5), 0.0, 0.04);
    return aim;
  };
  double on_it_N = 0.0;
  double beyond_N = 0.0;
  scene.watch = [&](const loop::TickOut& act, double now_s) {
    const double push_N = act.contact.in_body ? act.force.N.norm() : 0.0;
    if (now_s > 2.0 && now_s < 2.5) on_it_N = std::max(on_it_N, push_N);
    if (act.contact.coverage < 0.5 && act.contact.in_body) beyond_N = std::max(beyond_N, push_N);
  };
  const Felt felt = feel(scene);
  return all_of({above("on it", on_it_N, 0.3, 1.0, "N"),
                 below("where half is known: share", beyond_N / on_it_N, 0.6, 100.0, "%"),
                 below_N("step", felt.worst_step_N, 0.1)});
}

/// The skin is hidden for 0.3 s in a contact, in which the hand goes 40 mm deeper. The contact fades and comes back.
AssertionResult hidden_while_the_hand_goes_deeper() {
  std::vector<::testing::AssertionResult> anchors;
  for (const auto anchor : {effects::SkinAnchor::FollowsSurface, effects::SkinAnchor::Sliding}) {
    MovingSkinScene scene;
    scene.seconds = 8.0;
    scene.effects = the_skin({.law = effects::linear_law(150.0), .anchor = anchor});
    scene.skin = [](double now_s) { return MovingSkin::Shape{.ends_at_x_m = now_s > 3.0 && now_s < 3.3 ? -0.1 : 1e3}; };
    scene.person = [](const device::TrialView& view) {
      device::Intention aim = presses_to(0.02)(view);
      aim.at.m.y() -= 0.04 * std::clamp((view.time_s - 3.0) / 0.3, 0.0, 1.0);
      return aim;
    };
    double least_coverage = 1.0, least_J = 0.0, off = 0.0;
    scene.watch = [&](const loop::TickOut& act, double now_s) {
      if (now_s > 3.0 && act.contact.in_body) least_coverage = std::min(least_coverage, act.contact.coverage);
      if (now_s > 2.5) least_J = std::min(least_J, act.control.passivity_J);
      if (now_s > 6.0) off = std::max(off, std::abs(act.force.N.y() / (150.0 * -act.sample.device[1]) - 1.0));
    };
    const Felt felt = feel(scene);
    anchors.push_back(
        all_of({below("the coverage fell to", least_coverage, 0.5, 1.0, ""),
                above("display's ledger", least_J, -0.001, 1e3, "mJ"),
                below("off the law after 3 s", off, 0.05, 100.0, "%"), below_N("step", felt.worst_step_N, 0.1)}));
  }
  return anchors[0] ? anchors[1] : anchors[0];
}

/// Frames stop from 3 to 5 s while a hand presses the skin, and the patient is higher when they come back.
struct Gap {
  effects::SkinAnchor anchor = effects::SkinAnchor::FollowsSurface;
  double skin_N_per_m = 300.0;
  double arm_N_per_m = 300.0;
  double aim_m = 0.03;    ///< below the skin before the gap
  double risen_m = 0.02;  ///< in the gap
};
struct AfterGap {
  double step_N = 0.0;
  double felt_s = 1e9;         ///< from the frames' return until a lasting force
  double nine_tenths_s = 1e9;  ///< until 90 % of the law's force
  double off = 0.0;            ///< mean deviation from the law, 3 to 3.5 s after the return
};

AfterGap feel(const Gap& gap) {
  const effects::SkinLaw law = effects::linear_law(gap.skin_N_per_m);
  loop::HapticLoop loop({}, control::EncounteredController({}, the_skin({.law = law, .anchor = gap.anchor})));
  device::SimulatedPair pair({}, {.stiffness_N_per_m = gap.arm_N_per_m});
  pair.place({{0.0, 0.05, 0.0}}, {{0.0, 0.06, 0.0}});
  ShownSurface shown;
  const Person person = presses_to(gap.aim_m);
  constexpr double kStops_s = 3.0, kReturns_s = 5.0;
  AfterGap got;
  double force_sum_N = 0.0, law_sum_N = 0.0;
  Eigen::Vector3d last_N = Eigen::Vector3d::Zero();
  for (int tick = 0; tick < 20000; ++tick) {
    const double now_s = tick * LoopScene::kTick_s;
    loop::TickIn in = in_of(pair, now_s);
    if (tick % LoopScene::kTicksPerFrame == 0 && (now_s < kStops_s || now_s > kReturns_s)) {
      const double height_m = now_s < kStops_s ? 0.0 : gap.risen_m;
      auto newer = std::make_shared<MovingSkin>(MovingSkin::Shape{.flat_m = height_m}, at_s(now_s));
      in.surface = shown.show({std::move(newer), {}});
    }
    if (tick % LoopScene::kTicksPerSample == 0) in.hand = {at_s(now_s), pair.true_hand()};
    const loop::TickOut act = loop.tick(in);
    if (now_s > 2.5) got.step_N = std::max(got.step_N, (act.force.N - last_N).norm());
    last_N = act.force.N;
    const double law_N = std::min(kPeak_N, gap.skin_N_per_m * (gap.risen_m - pair.device().m.y()));
    if (now_s > kReturns_s) {
      const double since_s = now_s - kReturns_s;
      got.felt_s = act.contact.in_body && act.force.N.y() > 0.2 ? std::min(got.felt_s, since_s) : 1e9;
      if (act.force.N.y() >= 0.9 * law_N) got.nine_tenths_s = std::min(got.nine_tenths_s, since_s);
    }
    if (now_s > kReturns_s + 3.0 && now_s < kReturns_s + 3.5) {
      force_sum_N += act.force.N.y();
      law_sum_N += law_N;
    }
    pair.step(act.force, person({now_s, act.contact, pair.device()}), LoopScene::kTick_s);
  }
  got.off = std::abs(force_sum_N / law_sum_N - 1.0);
  return got;
}

/// `gap` with each anchor; the result of the first anchor that `judge` refuses, otherwise that of the last one.
AssertionResult with_each_anchor(Gap gap, AssertionResult (*judge)(const AfterGap& after)) {
  gap.anchor = effects::SkinAnchor::FollowsSurface;
  if (const AssertionResult follows = judge(feel(gap)); !follows) return follows;
  gap.anchor = effects::SkinAnchor::Sliding;
  return judge(feel(gap));
}

AssertionResult gap_in_contact() {
  return with_each_anchor({}, [](const AfterGap& after) {
    return all_of({below("felt again", after.felt_s, 1.5, 1.0, "s"),
                   below("off the law after 3 s", after.off, 0.05, 100.0, "%"), below_N("step", after.step_N, 0.2)});
  });
}

/// The displayed skin has 54 mm to rise, and a soft arm gives way to it only while it is pressed.
AssertionResult gap_under_a_soft_arm() {
  const Gap gap{.skin_N_per_m = 500.0, .arm_N_per_m = 200.0, .aim_m = 0.024, .risen_m = 0.03};
  return with_each_anchor(gap, [](const AfterGap& after) {
    return all_of({below("90 % of the law", after.nine_tenths_s, 1.2, 1.0, "s"),
                   below("off the law after 3 s", after.off, 0.02, 100.0, "%"), below_N("step", after.step_N, 0.1)});
  });
}

}  // namespace

std::vector<HardCase> moving_skin_rows() {
  return {
      {"patient steps by 10 mm under a hand", "damping multiplies the step of speed",
       "0.1 N a tick, 0.6 s, at any rate", step_by_10_mm},
      {"let go as the patient sinks", "the delayed display returns what is no longer stored",
       "no more than the hand had stored", let_go_as_it_sinks},
      {"rubbed in step with the breath", "the skin's speed differs from place to place",
       "the anchor stays at its skin point", rubbed_in_step_with_the_breath},
      {"default skin rubbed off a rim", "the anchor is far from the rim", "fades with the known surface", off_the_rim},
      {"2 s without frames, then 20 mm up", "the contact ended at depth", "felt in 1.5 s, law in 3 s, both anchors",
       gap_in_contact},
      {"2 s without frames, 30 mm up, soft arm", "the hand lies 54 mm below the skin", "90 % in 1.2 s, law in 3 s",
       gap_under_a_soft_arm},
      {"hidden while the hand goes deeper", "the skin's coverage grows under a deep hand", "no energy of the display",
       hidden_while_the_hand_goes_deeper},
  };
}

}  // namespace telepalp::hard_cases
