#include <limits>

#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/controller_scene.h"
#include "tests/hard_cases/control/forced_path.h"
#include "tests/hard_cases/control/loop_scene.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using control::Phase;
using device::BreathingPlane;
using ports::SurfaceContact;
using ::testing::AssertionResult;

AssertionResult swapped_in_contact() {
  LoopScene scene;
  scene.seconds = 4.0;
  scene.effects = the_skin({.law = effects::linear_law(300.0), .anchor = effects::SkinAnchor::Sliding});
  scene.camera = [](int tick, double now_s) {
    return tick % LoopScene::kTicksPerFrame == 0 ? std::optional(SeenPlane{now_s, now_s > 2.5 ? 0.005 : 0.0})
                                                 : std::nullopt;
  };
  double proxy_m = 0.0;
  scene.watch = [&](const auto& act, double, const auto&, const auto&) { proxy_m = act.contact.proxy.m.y(); };
  const Felt felt = feel(scene);
  return all_of({below_N("slewed: step", felt.worst_step_N, 0.05),
                 below_mJ("energy given", felt.energy_out_J, 1.0),
                 below_m("and it arrives", std::abs(proxy_m - 0.005), 1e-4),
                 {control::is_inside(felt.last.phase), "contact holds"}});
}

/// The worst case: a surface that jumps without gradual change. The ledger registers the energy of the step, and the
/// damping takes it back from a moving hand.
AssertionResult stepped_in_contact() {
  ControllerScene scene =
      with_only(effects::Skin({.law = effects::linear_law(300.0), .anchor = effects::SkinAnchor::Sliding}));
  scene.seconds = 6.0;
  scene.person = [](const device::TrialView& view) {
    device::Intention aim = presses_to(0.03)(view);
    if (view.time_s > 1.5) aim.at.m.y() += 0.01 * std::sin(2.0 * std::numbers::pi * (view.time_s - 1.5));
    return aim;
  };
  scene.surface = [](const Point<HapticBase>& device, double time_s) {
    return BreathingPlane{.height_m = time_s > 2.5 ? 0.005 : 0.0}(device, 0.0);
  };
  double given_J = 0.0;
  scene.watch = [&](const control::ControlOutput& out, double) { given_J = std::max(given_J, -out.passivity_J); };
  const Felt felt = feel(scene);
  return all_of({{felt.most_N <= kPeak_N, "below the peak"},
                 below("no kick", felt.fastest_device, 0.6, 1.0, "m/s"),
                 above("what the step gave", given_J, 1e-3, 1e3, "mJ"),
                 below_mJ("is taken back", -felt.last.passivity_J, 0.1),
                 {control::is_inside(felt.last.phase), "contact holds"}});
}

/// The camera sees nothing beyond x = 20 mm.
SurfaceContact with_edge(const Point<HapticBase>& device, double time_s) {
  return device.m.x() > 0.02 ? SurfaceContact{} : BreathingPlane{}(device, time_s);
}

AssertionResult in_over_the_edge() {
  ForcedPath scene;
  scene.surface = with_edge;
  scene.path = [](double since_down_s) -> Eigen::Vector3d {  // down to 20 mm beside the surface, then sideways under it
    const double down_m = std::min(0.02, 0.02 * since_down_s);
    return {std::max(-0.02, 0.05 - 0.03 * std::max(0.0, since_down_s - 2.0)), -down_m, 0.0};
  };
  double beyond_N = 0.0;
  scene.watch = [&](const control::ControlOutput& out, double now_s) {
    if (now_s > 3.0 && now_s < 4.9) beyond_N = std::max(beyond_N, out.force.N.norm());
  };
  const Felt felt = feel(scene);
  return all_of({{beyond_N == 0.0, "no force beyond it"},
                 {felt.body_entries == 1 && felt.last.phase == Phase::InBody, "met when under it"},
                 below_N("step", felt.worst_step_N, 0.05),
                 above("then felt", felt.last.force.N.norm(), 0.5, 1.0, "N")});
}

AssertionResult off_over_the_edge() {
  ControllerScene scene;
  scene.seconds = 8.0;
  scene.surface = with_edge;
  scene.person = rubs_at(0.02, 0.03);  // off and on again, once a second
  const Felt felt = feel(scene);
  return all_of({below_N("step", felt.worst_step_N, 0.05),
                 below_mJ("energy given", felt.energy_out_J, 1.0),
                 below("no loop: changes in 8 s", felt.changes, 8.0 / 0.3, 1.0, ""),
                 {!felt.faulted, "no fault"}});
}

Felt risen_under_a_waiting_device(double speed_m_per_s) {
  ControllerScene scene;
  scene.seconds = 6.0;
  scene.person = waits_at(0.15);
  scene.surface = [=](const Point<HapticBase>& device, double time_s) {
    const double height_m = std::clamp(speed_m_per_s * (time_s - 2.0), 0.0, 0.06);
    SurfaceContact contact = BreathingPlane{.height_m = height_m}(device, 0.0);
    contact.surface_speed_m_per_s = height_m > 0.0 && height_m < 0.06 ? speed_m_per_s : 0.0;
    return contact;
  };
  return feel(scene);
}

AssertionResult rises_under_the_plane() {
  const Felt felt = risen_under_a_waiting_device(0.04);
  return all_of({{felt.body_entries == 0, "never met"},
                 above("the plane rose with it", felt.last.plane_height_m, 0.079, 1e3, "mm"),
                 {felt.last.phase == Phase::OutBody, "waits on the plane"},
                 below_N("step", felt.worst_step_N, 0.05)});
}

AssertionResult coughs_up_into_it() {
  const Felt felt = risen_under_a_waiting_device(0.5);
  return all_of({below_N("step", felt.worst_step_N, 0.05),
                 below_N("force", felt.most_N, 4.0),
                 below("slower than the cough", felt.fastest_device, 0.5, 1.0, "m/s"),
                 {felt.last.phase == Phase::OutBody, "ends waiting on the plane"}});
}

/// The hand has pushed the end-effector below the plane and holds it there, without position control, when the skin
/// rises to it.
AssertionResult rises_under_a_held_hand() {
  ControllerScene scene;
  scene.seconds = 6.0;
  scene.person = presses_to(-0.015);
  scene.surface = [](const Point<HapticBase>& device, double time_s) {
    const double height_m = std::clamp(0.03 * (time_s - 3.0), 0.0, 0.03);
    SurfaceContact contact = BreathingPlane{.height_m = height_m}(device, 0.0);
    contact.surface_speed_m_per_s = height_m > 0.0 && height_m < 0.03 ? 0.03 : 0.0;
    return contact;
  };
  const Felt felt = feel(scene);
  return all_of({{felt.body_entries == 1, "met once"},
                 below_N("it grows: step", felt.worst_step_N, 0.05),
                 {control::is_inside(felt.last.phase), "felt as skin"},
                 above("force", felt.last.force.N.y(), 0.05, 1.0, "N")});
}

AssertionResult flickers() {
  ControllerScene scene;
  scene.person = presses_to(0.03);
  scene.surface = [](const Point<HapticBase>& device, double time_s) {
    const bool hole = time_s >= 2.5 && std::fmod(time_s, 1.0 / 15.0) <= 0.03;
    return hole ? SurfaceContact{} : BreathingPlane{}(device, time_s);
  };
  const Felt felt = feel(scene);
  return all_of({below_N("step: only damping may be quick", felt.worst_step_N, 0.3),
                 below_mJ("energy given", felt.energy_out_J, 2.0)});
}

AssertionResult never_there() {
  ControllerScene scene;
  scene.surface = [](const Point<HapticBase>&, double) {
    SurfaceContact none;
    none.age_s = std::numeric_limits<double>::infinity();
    return none;
  };
  const Felt felt = feel(scene);
  return all_of({{felt.last.phase == Phase::Released, "released"}, {felt.most_N == 0.0, "no force"}});
}

AssertionResult far_away() {
  ControllerScene near = with_only(effects::Skin{});
  near.person = presses_to(0.04);
  ControllerScene far = near;
  const Eigen::Vector3d shift{100.0, 0.0, -100.0};
  far.device.m += shift;
  far.hand.m += shift;
  far.person = [=](const device::TrialView& view) {
    device::Intention aim = presses_to(0.04)(view);
    aim.at.m += shift;
    return aim;
  };
  const double off_N = std::abs(feel(near).last.force.N.norm() - feel(far).last.force.N.norm());
  return all_of({below_N("as at the origin, to", off_N, 0.02)});
}

}  // namespace

std::vector<HardCase> surface_rows() {
  return {
      {"22 surface swap in contact", "a jump would give the hand energy", "gradual, energy bounded, arrives",
       swapped_in_contact},
      {"22 an unslewed step of 5 mm", "the worst that a surface can do", "force and speed bounded", stepped_in_contact},
      {"in over the surface's edge", "contact begins below the skin", "no force beyond the rim, then it grows",
       in_over_the_edge},
      {"off over the surface's edge", "the contact ends at depth", "fades, no repeated phase changes",
       off_over_the_edge},
      {"patient rises under the plane", "the device waits where the skin will be", "the plane rises, no contact",
       rises_under_the_plane},
      {"patient coughs up into it", "0.5 m/s, five times the plane's speed", "gentle, ends above", coughs_up_into_it},
      {"patient rises under a held hand", "the skin moves to the hand", "one contact, force grows from 0",
       rises_under_a_held_hand},
      {"surface flickers 15 times a second", "each time a contact ends at depth", "no energy given", flickers},
      {"never a surface", "no contact is ever valid", "released, no force", never_there},
      {"32 a scene 100 m away", "rounding of differences", "as at the origin", far_away},
  };
}

}  // namespace telepalp::hard_cases
