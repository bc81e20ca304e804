#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/controller_scene.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using control::Phase;
using ::testing::AssertionResult;

AssertionResult stiff_and_light() {
  ControllerScene scene = with_only(effects::Skin({.law = effects::linear_law(5000.0)}));
  scene.settings.device.mass_kg = 0.1;
  scene.settings.device.damping_N_s_per_m = 0.2;
  scene.settings.hand = {.mass_kg = 0.1, .stiffness_N_per_m = 200.0, .damping_N_s_per_m = 2.0};
  scene.settings.hand.pad_damping_N_s_per_m = 0.5;  // a hand with almost no damping
  scene.person = presses_to(0.01);
  const Felt felt = feel(scene);
  return all_of({{felt.finite, "finite"},
                 below_mJ("no energy gain", felt.energy_out_J, 1.0),
                 below("the device stays slow", felt.fastest_device, 0.5, 1.0, "m/s"),
                 {felt.most_N <= kPeak_N, "below the peak"}});
}

AssertionResult stacked() {
  effects::StiffRegions regions;
  for (int i = 0; i < 8; ++i) (void)regions.add({.center = {}, .added_N_per_m = 3000.0});
  ControllerScene scene = with_only(effects::Skin({.law = effects::linear_law(5000.0)}), regions);
  scene.person = presses_to(0.01);
  const Felt felt = feel(scene);
  return all_of({{felt.finite, "finite"},
                 below_mJ("no energy gain", felt.energy_out_J, 1.0),
                 below("the device stays slow", felt.fastest_device, 0.5, 1.0, "m/s"),
                 below_N("step", felt.worst_step_N, 0.5),
                 {felt.most_N <= kPeak_N, "below the peak"}});
}

/// A hand that rubs over the rim of an added effect, to both sides.
struct Rubbed {
  Felt felt;
  double farthest_m = 0.0;  ///< farthest reach from the middle, on the side that was reached less
};

Rubbed rubbed_over(ControllerScene scene) {
  Rubbed rubbed;
  double least_m = 0.0;
  double most_m = 0.0;
  scene.seconds = 6.0;
  scene.person = rubs_at(0.06, 0.08);
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s < 2.0) return;
    least_m = std::min(least_m, out.target.m.x());
    most_m = std::max(most_m, out.target.m.x());
  };
  rubbed.felt = feel(scene);
  rubbed.farthest_m = std::min(-least_m, most_m);
  return rubbed;
}

AssertionResult smooth_over_the_rim(const Rubbed& rubbed, double rim_m, double most_step_N) {
  return all_of({above("rubs over it", rubbed.farthest_m, rim_m, 1e3, "mm"),
                 below_mJ("energy given", rubbed.felt.energy_out_J, 1.0),
                 below_N("step", rubbed.felt.worst_step_N, most_step_N),
                 {rubbed.felt.most_N <= kPeak_N, "below the peak"},
                 above("and it is felt", rubbed.felt.most_N, 2.0, 1.0, "N")});
}

AssertionResult over_the_cylinders_rim() { return smooth_over_the_rim(rubbed_over({}), 0.035, 0.25); }

AssertionResult over_a_sphere() {
  return smooth_over_the_rim(
      rubbed_over(with_only(effects::Skin{}, effects::InnerSphere({.center = {{0.0, -0.05, 0.0}}}))), 0.025, 0.25);
}

Rubbed rubbed_over_a_region(const effects::StiffRegion& region) {
  effects::StiffRegions regions;
  (void)regions.add(region);
  return rubbed_over(
      with_only(effects::Skin({.law = effects::linear_law(160.0), .anchor = effects::SkinAnchor::Sliding}), regions));
}

AssertionResult over_a_regions_rim() {
  return smooth_over_the_rim(rubbed_over_a_region({.center = {}, .radius_m = 0.01}), 0.032, 0.6);
}

/// A rim so steep that its sideways force far exceeds the peak, so that the limiter determines the force.
AssertionResult over_a_cliff() {
  const Rubbed rubbed = rubbed_over_a_region({.center = {}, .radius_m = 0.01, .fade_m = 0.005, .added_N_per_m = 800.0});
  const control::ForceLimits limits;
  return all_of({below_mJ("energy given", rubbed.felt.energy_out_J, 1.0),
                 {rubbed.felt.most_N <= limits.peak_N, "below the peak"},
                 below_N("step within the slew", rubbed.felt.worst_step_N, limits.slew_N_per_s * 0.0005 + 1e-9),
                 below("as fast as the hand", rubbed.felt.fastest_device, 1.0, 1.0, "m/s")});
}

/// A hand that has dug in beside an object, and is drawn sideways into it.
AssertionResult from_the_side() {
  ControllerScene scene;
  scene.seconds = 5.0;
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.06, 0.06)(view);
    aim.at.m.x() = std::max(0.0, 0.06 - 0.08 * std::max(0.0, view.time_s - 2.0));
    return aim;
  };
  bool lateral = false;
  scene.watch = [&](const control::ControlOutput& out, double) {
    lateral = lateral || out.phase == Phase::ObjectLateral;
  };
  const Felt felt = feel(scene);
  return all_of({{lateral, "its side is met"},
                 below_N("step", felt.worst_step_N, 0.05),
                 below_mJ("energy given", felt.energy_out_J, 1.0)});
}

/// The station released while the hand pressed. The hand sank into the cylinder and now feels it again. It has done no
/// work against the cylinder, so the cylinder must not give energy.
AssertionResult begins_inside() {
  ControllerScene scene;
  scene.seconds = 8.0;
  scene.person = presses_to(0.045);
  scene.spoil = [](control::ControlInput& in, double now_s) {
    if (now_s > 2.5 && now_s < 4.0) in.contact.age_s = 2.0;
  };
  double begun_N = 0.0;
  double least_J = 0.0;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 4.0 && begun_N == 0.0) begun_N = out.force.N.norm();
    if (now_s > 4.0) least_J = std::min(least_J, out.passivity_J);
  };
  const Felt felt = feel(scene);
  return all_of({{felt.last.phase == Phase::ObjectUpper, "felt again, in the cylinder"},
                 below_N("begins with", begun_N, 0.05),
                 below_N("step", felt.worst_step_N, 0.2),
                 below_mJ("energy given", -least_J, 1.0)});
}

AssertionResult objects_in_one_another() {
  ControllerScene scene;
  (void)scene.settings.effects.add(effects::InnerSphere({.center = {{0.0, -0.04, 0.0}}}));
  scene.person = presses_to(0.06);
  const Felt felt = feel(scene);
  return all_of({{felt.most_N <= kPeak_N, "below the peak"},
                 below_N("step", felt.worst_step_N, 0.15),
                 below_mJ("energy given", felt.energy_out_J, 1.0)});
}

/// A valley of two planes at 90 degrees along z: both planes are touched at once.
ports::SurfaceContact in_a_crease(const Point<HapticBase>& device, double) {
  const Eigen::Vector3d left = Eigen::Vector3d(1, 1, 0).normalized();
  const Eigen::Vector3d right = Eigen::Vector3d(-1, 1, 0).normalized();
  const double under_left_m = -left.dot(device.m);
  const double under_right_m = -right.dot(device.m);
  ports::SurfaceContact contact;
  contact.valid = true;
  contact.in_body = std::max(under_left_m, under_right_m) > 0.0;
  contact.proxy.m = device.m + std::max(0.0, under_left_m) * left + std::max(0.0, under_right_m) * right;
  contact.normal.v = under_left_m > under_right_m ? left : right;
  if (contact.in_body) contact.normal.v = (contact.proxy.m - device.m).normalized();
  contact.distance_m = contact.in_body ? -(contact.proxy.m - device.m).norm() : -std::max(under_left_m, under_right_m);
  return contact;
}

AssertionResult crease() {
  ControllerScene scene =
      with_only(effects::Skin({.law = effects::linear_law(500.0), .anchor = effects::SkinAnchor::Sliding}));
  scene.seconds = 6.0;
  scene.surface = in_a_crease;
  scene.person = rubs_at(0.02, 0.015);
  const Felt felt = feel(scene);
  return all_of({below_N("no chatter: step", felt.worst_step_N, 0.1),
                 below_mJ("energy given", felt.energy_out_J, 1.0),
                 {felt.body_entries == 1, "one contact"},
                 above("and it holds", felt.most_N, 2.0, 1.0, "N")});
}

AssertionResult friction_at_rest() {
  const effects::SkinLaw law = effects::linear_law(500.0);
  ControllerScene scene = with_only(effects::Skin({.law = law, .anchor = effects::SkinAnchor::Sliding}),
                                    effects::Friction({.coefficient = 0.4, .load = law}));
  scene.seconds = 12.0;
  scene.person = [](const device::TrialView& view) {  // pulls sideways with half of what friction holds, and trembles
    device::Intention aim = presses_to(0.02)(view);
    aim.at.m.x() = 0.003 * std::min(1.0, std::max(0.0, view.time_s - 2.0)) +
                   0.0003 * std::sin(2.0 * std::numbers::pi * 9.0 * view.time_s);
    return aim;
  };
  double step_N = 0.0;
  Eigen::Vector3d before_N = Eigen::Vector3d::Zero();
  double at_4_s_m = 0.0;
  double moved_m = 0.0;
  double mean_m = 0.0;
  int ticks = 0;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 4.0) step_N = std::max(step_N, (out.force.N - before_N).norm());
    before_N = out.force.N;
    mean_m += out.target.m.x();
    if (++ticks < 2000) return;  // means over whole seconds remove the tremor
    mean_m /= ticks;
    if (now_s < 4.5) at_4_s_m = mean_m;
    moved_m = std::abs(mean_m - at_4_s_m);
    mean_m = 0.0;
    ticks = 0;
  };
  const Felt felt = feel(scene);
  const double held_N = std::abs(felt.last.force.N.x());
  return all_of({below_m("does not creep in 7 s", moved_m, 2e-5), below_N("no chatter: step", step_N, 0.02),
                 above("though it holds", held_N, 0.2, 1.0, "N"), below_mJ("energy given", felt.energy_out_J, 1.0)});
}

}  // namespace

std::vector<HardCase> contact_rows() {
  return {
      {"18 k dt2/m: 5000 N/m on 0.1 kg", "a force held over a tick adds energy", "no energy gain, bounded",
       stiff_and_light},
      {"18 29 kN/m stacked in one place", "7 times as stiff as the device can show", "stable and slow", stacked},
      {"19 the cylinder's rim", "five times as stiff, at an edge", "energy bounded, no step", over_the_cylinders_rim},
      {"19 the sphere's boundary", "stiffness starts at a boundary", "energy bounded, no step", over_a_sphere},
      {"19 a stiff region's rim", "a force with k(x) is not conservative", "energy bounded, no step",
       over_a_regions_rim},
      {"19 a cliff of 800 N/m over 5 mm", "hundreds of newtons sideways", "the limiter's peak and slew, no energy",
       over_a_cliff},
      {"19 an inclusion from its side", "upper and lateral force meet at the rim", "lateral phase, no step",
       from_the_side},
      {"19 contact begins in an inclusion", "the hand did no work to enter it", "force grows from 0, no energy given",
       begins_inside},
      {"two contacts: objects overlap", "their forces add up", "smooth, below the peak", objects_in_one_another},
      {"two contacts: a crease", "two planes constrain the proxy", "one smooth contact, no chatter", crease},
      {"26 friction at zero velocity", "at rest, velocity has no direction", "true stick: no creep, no chatter",
       friction_at_rest},
  };
}

}  // namespace telepalp::hard_cases
