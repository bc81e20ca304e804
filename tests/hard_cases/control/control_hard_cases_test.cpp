#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/device/virtual_station.h"
#include "haptic_station/trials/trial_run.h"

namespace telepalp {
namespace {

using control::ControlInput;
using control::ControlOutput;
using control::Phase;
using control::SurfaceContact;
using device::BreathingPlane;
using device::Intention;
using device::TrialView;

/// What a scene did to the hand, to hold against what may happen.
struct Felt {
  double worst_step_N = 0.0;
  double most_N = 0.0;
  double fastest_device = 0.0;  // [m/s]
  double energy_out_J = 0.0;    // most that the display has given out, net, over the run
  int changes = 0;
  int body_entries = 0;
  bool finite = true;
  bool faulted = false;
  ControlOutput last;
};

/// A scene in virtual time. What is left out is a still skin at 0 and a hand that waits above it.
struct Scene {
  double seconds = 4.0;
  device::VirtualStationSettings settings = trials::paper_settings();
  Point<HapticBase> device{{0.0, 0.03, 0.0}};
  Point<HapticBase> hand{{0.0, 0.05, 0.0}};
  std::function<SurfaceContact(const Point<HapticBase>&, double)> skin = BreathingPlane{};
  std::function<Intention(const TrialView&)> person = [](const TrialView&) {
    return Intention{{{0.0, 0.05, 0.0}}, {}};
  };
  std::function<void(ControlInput&, double)> spoil = [](ControlInput&, double) {};
};

Felt feel(const Scene& scene) {
  device::VirtualStation station(scene.settings);
  station.place(scene.device, scene.hand);
  Felt felt;
  double energy_J = 0.0;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  const auto ticks = static_cast<int>(scene.seconds / scene.settings.tick_s);
  for (int i = 0; i < ticks; ++i) {
    const double now_s = station.time_s();
    const Eigen::Vector3d before_m = station.pair().true_device().m;
    const ControlOutput out = station.step(scene.skin, scene.person, [&](ControlInput& in) { scene.spoil(in, now_s); });
    const Eigen::Vector3d moved_m = station.pair().true_device().m - before_m -
                                    Eigen::Vector3d::UnitY() * out.surface_speed_m_per_s * scene.settings.tick_s;
    if (control::is_inside(out.phase)) energy_J -= out.force.N.dot(moved_m);
    felt.energy_out_J = std::max(felt.energy_out_J, -energy_J);
    felt.worst_step_N = std::max(felt.worst_step_N, (out.force.N - force_N).norm());
    felt.most_N = std::max(felt.most_N, out.force.N.norm());
    felt.fastest_device = std::max(felt.fastest_device, station.pair().true_device_velocity().v.norm());
    felt.finite = felt.finite && out.force.N.allFinite() && out.displayed_hand.m.allFinite();
    felt.faulted = felt.faulted || out.phase == Phase::Faulted;
    if (out.phase != out.previous) ++felt.changes;
    if (out.phase == Phase::InBody && !control::is_inside(out.previous)) ++felt.body_entries;
    force_N = out.force.N;
    felt.last = out;
  }
  return felt;
}

/// A hand that goes down through the plane and presses to `depth_m` from 1.2 s on.
std::function<Intention(const TrialView&)> presses_to(double depth_m, double x_m = 0.0) {
  return [=](const TrialView& view) {
    const double share = std::clamp((view.time_s - 0.7) / 0.8, 0.0, 1.0);
    const double ease = share * share * (3.0 - 2.0 * share);
    return Intention{{{x_m, 0.06 - ease * (0.06 + depth_m), 0.0}}, {}};
  };
}

struct HardCase {
  std::string name;
  std::string must;  ///< what must happen
  std::function<void()> check;
};

Felt felt_on_entering_at(double speed_m_per_s) {
  Scene scene;
  scene.seconds = 3.0;
  scene.person = [=](const TrialView& view) {
    const double fallen_m = std::max(0.0, view.time_s - 1.5) * speed_m_per_s;
    return Intention{{{0.1, std::max(-0.03, 0.06 - fallen_m), 0.0}}, {}};
  };
  return feel(scene);
}

SurfaceContact with_edge(const Point<HapticBase>& device, double time_s) {
  SurfaceContact contact = BreathingPlane{}(device, time_s);
  if (device.m.x() > 0.02) contact = SurfaceContact{};  // the camera sees nothing there
  return contact;
}

std::vector<HardCase> hard_cases() {
  return {
      {"TheStiffestThatASceneMayAskFor", "5000 N/m, past the Z-width at 2 kHz: no energy gain, bounded",
       [] {
         Scene scene;
         scene.settings.effects = {};
         (void)scene.settings.effects.add(effects::Skin({.law = effects::linear_law(5000.0)}));
         scene.person = presses_to(0.01);
         const Felt felt = feel(scene);
         EXPECT_TRUE(felt.finite);
         EXPECT_LE(felt.most_N, 10.0);
         EXPECT_LT(felt.fastest_device, 0.5);
         EXPECT_LE(felt.energy_out_J, 0.001);
       }},
      {"EffectsStackedInOnePlace", "29 kN/m together, seven times what the device can show: as calm as what it can",
       [] {
         Scene scene;
         scene.settings.effects = {};
         (void)scene.settings.effects.add(effects::Skin({.law = effects::linear_law(5000.0)}));
         effects::StiffRegions regions;
         for (int i = 0; i < 8; ++i) (void)regions.add({.center = {}, .added_N_per_m = 3000.0});
         (void)scene.settings.effects.add(regions);
         scene.person = presses_to(0.01);
         const Felt felt = feel(scene);
         EXPECT_TRUE(felt.finite);
         EXPECT_LE(felt.most_N, 10.0);
         EXPECT_LT(felt.fastest_device, 0.5);
         EXPECT_LE(felt.energy_out_J, 0.001);
         EXPECT_LE(felt.worst_step_N, 0.5);
       }},
      {"StiffnessJumpsAtAnInclusion", "energy bounded at the edge of something five times as stiff",
       [] {
         Scene scene;
         scene.seconds = 6.0;
         scene.person = [](const TrialView& view) {  // rubs over the cylinder's rim
           Intention aim = presses_to(0.06)(view);
           aim.at.m.x() = 0.03 * std::sin(2.0 * std::numbers::pi * 1.0 * view.time_s);
           return aim;
         };
         const Felt felt = feel(scene);
         EXPECT_LE(felt.energy_out_J, 0.001);
         EXPECT_LE(felt.worst_step_N, 0.25);
       }},
      {"SurfaceStepsInContact", "a 5 mm step of the skin injects bounded energy and no kick past the limits",
       [] {
         Scene scene;
         scene.person = presses_to(0.03);
         scene.skin = [](const Point<HapticBase>& device, double time_s) {
           return BreathingPlane{.height_m = time_s > 2.5 ? 0.005 : 0.0}(device, 0.0);
         };
         const Felt felt = feel(scene);
         EXPECT_LE(felt.most_N, 10.0);
         EXPECT_LT(felt.fastest_device, 0.6);
         EXPECT_TRUE(control::is_inside(felt.last.phase));
       }},
      {"HandRemovedInContact", "the end-effector does not fly off; it ends waiting on the plane",
       [] {
         Scene scene;
         scene.seconds = 6.0;
         scene.person = [](const TrialView& view) {
           if (view.time_s < 2.5) return presses_to(0.05)(view);
           return Intention{{{0.3, 0.3, 0.0}}, {}};
         };
         const Felt felt = feel(scene);
         EXPECT_EQ(felt.last.phase, Phase::OutBody);
         EXPECT_LT(felt.fastest_device, 1.2);
         EXPECT_LE(felt.worst_step_N, 1.0);
       }},
      {"PatientMovesUpIntoARestingDevice", "the plane rises with the skin and the device with it",
       [] {
         Scene scene;
         scene.seconds = 5.0;
         scene.person = [](const TrialView&) { return Intention{{{0.0, 0.15, 0.0}}, {}}; };
         scene.skin = [](const Point<HapticBase>& device, double time_s) {
           const double height_m = std::clamp(0.04 * (time_s - 2.0), 0.0, 0.06);
           return BreathingPlane{.height_m = height_m}(device, 0.0);
         };
         const Felt felt = feel(scene);
         EXPECT_GE(felt.last.plane_height_m, 0.079);
         EXPECT_EQ(felt.last.phase, Phase::OutBody);
         EXPECT_LE(felt.worst_step_N, 0.05);
         EXPECT_EQ(felt.body_entries, 0);
       }},
      {"EntryAtThePlanesEdge", "beyond the surface's rim there is no contact, and coming in over it no step",
       [] {
         Scene scene;
         scene.seconds = 6.0;
         scene.skin = with_edge;
         scene.person = [](const TrialView& view) {
           Intention aim = presses_to(0.02, 0.05)(view);
           if (view.time_s > 3.0) aim.at.m.x() = std::max(-0.02, 0.05 - 0.03 * (view.time_s - 3.0));
           return aim;
         };
         const Felt felt = feel(scene);
         EXPECT_TRUE(felt.finite);
         EXPECT_LE(felt.worst_step_N, 0.05);
       }},
      {"TrackerSwapsHands", "another hand 0.4 m away moves the free device at its bounded speed, never in a jump",
       [] {
         Scene scene;
         scene.spoil = [](ControlInput& in, double now_s) {
           if (std::fmod(now_s, 1.0) > 0.5) in.hand.m.x() += 0.4;
         };
         const Felt felt = feel(scene);
         EXPECT_LE(felt.worst_step_N, 0.05);
         EXPECT_LE(felt.most_N, 3.0 + 1e-9);
       }},
      {"TwoContactsAtOnce", "skin, cylinder and a sphere inside it add up, smoothly and below the limit",
       [] {
         Scene scene;
         (void)scene.settings.effects.add(effects::InnerSphere({.center = {{0.0, -0.04, 0.0}}}));
         scene.person = presses_to(0.06);
         const Felt felt = feel(scene);
         EXPECT_LE(felt.most_N, 10.0);
         EXPECT_LE(felt.energy_out_J, 0.001);
       }},
      {"ClockSteps", "ages that jump or are not numbers release gently; nothing is felt of a step back",
       [] {
         Scene scene;
         scene.seconds = 5.0;
         scene.person = presses_to(0.03);
         scene.spoil = [](ControlInput& in, double now_s) {
           if (now_s > 2.5 && now_s < 2.6) in.hand_age_s = 3600.0;
           if (now_s > 3.5 && now_s < 3.6) in.contact.age_s = std::nan("");
           if (now_s > 4.5) in.hand_age_s = -3600.0;
         };
         const Felt felt = feel(scene);
         EXPECT_TRUE(felt.finite);
         EXPECT_FALSE(felt.faulted) << "a stale input is no fault";
         EXPECT_LE(felt.worst_step_N, 0.35)
             << "letting go takes 30 ms from the peak, and is the quickest change there is";
       }},
      {"DeviceSaturates", "a device that gives 2 N stays stable under a wish for 10",
       [] {
         Scene scene;
         scene.settings.device.peak_N = 2.0;
         scene.person = presses_to(0.05);
         const Felt felt = feel(scene);
         EXPECT_TRUE(felt.finite);
         EXPECT_LT(felt.fastest_device, 1.0);
         EXPECT_TRUE(control::is_inside(felt.last.phase));
       }},
      {"AFastHandAgainstTheDwell", "at 1.5 m/s the skin is felt at once, not 0.3 s late",
       [] {
         const Felt felt = felt_on_entering_at(1.5);
         EXPECT_GE(felt.body_entries, 1);
         EXPECT_LE(felt.most_N, 10.0);
         EXPECT_TRUE(control::is_inside(felt.last.phase));
       }},
      {"SurfaceComesAndGoes",
       "a hole that flickers 15 times a second: only damping may act quickly, and no energy comes of it",
       [] {
         Scene scene;
         scene.person = presses_to(0.03);
         scene.skin = [](const Point<HapticBase>& device, double time_s) {
           SurfaceContact contact = BreathingPlane{}(device, time_s);
           contact.valid = contact.valid && (time_s < 2.5 || std::fmod(time_s, 1.0 / 15.0) > 0.03);
           contact.in_body = contact.in_body && contact.valid;
           return contact;
         };
         const Felt felt = feel(scene);
         EXPECT_LE(felt.worst_step_N, 0.3);
         EXPECT_LE(felt.energy_out_J, 0.002);
       }},
      {"NeverASurface", "no surface at all: released, no force, no number that is not one",
       [] {
         Scene scene;
         scene.skin = [](const Point<HapticBase>&, double) {
           SurfaceContact none;
           none.age_s = std::numeric_limits<double>::infinity();
           return none;
         };
         const Felt felt = feel(scene);
         EXPECT_EQ(felt.last.phase, Phase::Released);
         EXPECT_EQ(felt.most_N, 0.0);
       }},
      {"FarFromTheOrigin", "a scene 100 m away is felt as one at the origin",
       [] {
         Scene near;
         near.person = presses_to(0.04);
         near.settings.effects = {};
         (void)near.settings.effects.add(effects::Skin{});
         Scene far = near;
         const Eigen::Vector3d shift{100.0, 0.0, -100.0};
         far.device.m += shift;
         far.hand.m += shift;
         far.person = [=](const TrialView& view) {
           Intention aim = presses_to(0.04)(view);
           aim.at.m += shift;
           return aim;
         };
         EXPECT_NEAR(feel(near).last.force.N.norm(), feel(far).last.force.N.norm(), 0.02);
       }},
  };
}

class ControlHardCases : public ::testing::TestWithParam<HardCase> {};

TEST_P(ControlHardCases, DoesWhatMustHappen) {
  SCOPED_TRACE(GetParam().must);
  GetParam().check();
}
INSTANTIATE_TEST_SUITE_P(Control, ControlHardCases, ::testing::ValuesIn(hard_cases()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace telepalp
