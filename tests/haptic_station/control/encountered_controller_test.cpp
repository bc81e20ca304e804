#include "haptic_station/control/encountered_controller.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/trials/virtual_station.h"

namespace telepalp {
namespace {

using control::ControlOutput;
using control::Event;
using control::Phase;

effects::EffectBank skin_and_cylinder() {
  effects::EffectBank bank;
  (void)bank.add(effects::Skin{});
  (void)bank.add(effects::InnerCylinder({.top_center = {{0.0, -0.03, 0.0}}}));
  return bank;
}

/// A trial over a level skin, with its figures.
struct TrialRun {
  std::set<Phase> visited;
  int body_entries = 0;
  double worst_step_N = 0.0;
  double worst_jump_m = 0.0;      // largest displacement of the end-effector at a transition, minus speed × tick
  double worst_speed_jump = 0.0;  // [m/s]
  double most_N = 0.0;
  double worst_shown_step_m = 0.0;  // largest displacement of the displayed hand in one tick
};

TrialRun run_trial(device::Trial trial, double breathing_m = 0.0) {
  trials::VirtualStationSettings settings;
  settings.effects = skin_and_cylinder();
  trials::VirtualStation station(settings);
  const device::Waypoint& start = device::waypoints(trial).back();
  station.place({{0.0, 0.03, 0.0}}, {{start.x_m, start.height_m, start.z_m}});
  device::ScriptedIntention person(device::waypoints(trial), {});
  const device::BreathingPlane skin{.amplitude_m = breathing_m};
  TrialRun result;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Point<HapticBase> shown;
  const auto ticks = static_cast<int>(device::duration_s(trial) / settings.tick_s);
  for (int i = 0; i < ticks; ++i) {
    const Eigen::Vector3d at_m = station.pair().true_device().m;
    const Eigen::Vector3d speed = station.pair().true_device_velocity().v;
    const ControlOutput out =
        station.step(skin, [&](const device::TrialView& view) { return person.step(view, settings.tick_s); });
    result.visited.insert(out.phase);
    result.worst_step_N = std::max(result.worst_step_N, (out.force.N - force_N).norm());
    result.most_N = std::max(result.most_N, out.force.N.norm());
    if (i > 0) result.worst_shown_step_m = std::max(result.worst_shown_step_m, (out.displayed_hand.m - shown.m).norm());
    if (out.phase != out.previous) {
      const Eigen::Vector3d moved = station.pair().true_device().m - at_m;
      result.worst_jump_m = std::max(result.worst_jump_m, (moved - speed * settings.tick_s).norm());
      result.worst_speed_jump =
          std::max(result.worst_speed_jump, (station.pair().true_device_velocity().v - speed).norm());
      if (out.event == Event::IntoBody) ++result.body_entries;
    }
    force_N = out.force.N;
    shown = out.displayed_hand;
  }
  return result;
}

TEST(EncounteredController, TheFirstTrialEntersAtThreePointsWithoutAJump) {
  const TrialRun trial = run_trial(device::Trial::IndentSeveralPoints);
  for (const Phase phase : {Phase::InBody, Phase::BodyToPlane, Phase::OutBody, Phase::PlaneToBody})
    EXPECT_TRUE(trial.visited.contains(phase)) << name(phase);
  EXPECT_EQ(trial.body_entries, 3);
  EXPECT_LE(trial.worst_jump_m, 0.0001);
  EXPECT_LE(trial.worst_speed_jump, 0.020);
  EXPECT_LE(trial.worst_step_N, 0.05);
}

TEST(EncounteredController, TheThirdTrialVisitsTheCylindersThreePhases) {
  const TrialRun trial = run_trial(device::Trial::FindCylinder);
  for (const Phase phase : {Phase::ObjectUpper, Phase::ObjectLateral, Phase::AroundObject})
    EXPECT_TRUE(trial.visited.contains(phase)) << name(phase);
  EXPECT_LE(trial.worst_step_N, 0.05);
  EXPECT_LE(trial.most_N, 10.0);
}

TEST(EncounteredController, EveryTrialIsSmoothOverABreathingPatient) {
  for (const auto trial : {device::Trial::IndentSeveralPoints, device::Trial::MoveWithin, device::Trial::FindCylinder,
                           device::Trial::FreeSearch}) {
    SCOPED_TRACE(static_cast<int>(trial));
    const TrialRun result = run_trial(trial, 0.005);
    EXPECT_TRUE(result.visited.contains(Phase::InBody));
    EXPECT_TRUE(result.visited.contains(Phase::OutBody));
    EXPECT_FALSE(result.visited.contains(Phase::Faulted));
    EXPECT_LE(result.worst_step_N, 0.05);
    EXPECT_LE(result.worst_shown_step_m, 0.005) << "the tracker's own steps, no more";
  }
}

/// A controller with scripted inputs and the end-effector held at a point.
struct Fed {
  control::ControlSettings settings;
  control::EncounteredController controller{settings, skin_and_cylinder()};
  device::BreathingPlane skin;
  control::ControlInput in;
  Fed() {
    in.device.m = {0.1, 0.05, 0.0};
    in.hand.m = {0.1, 0.05, 0.0};
    in.hand_valid = true;
  }
  ControlOutput at_height(double y_m, int ticks = 1) {
    ControlOutput out;
    for (int i = 0; i < ticks; ++i) {
      in.device.m.y() = y_m;
      in.hand.m.y() = y_m;
      in.contact = skin(in.device, 0.0);
      out = controller.step(in, 0.0005);
    }
    return out;
  }
  ControlOutput into_body() {
    (void)at_height(0.05, 2000);
    (void)at_height(0.02, 1000);
    return at_height(-0.02, 2000);  // the sink-in rises at 0.1 m/s
  }
};

TEST(EncounteredController, GoesRoundThePapersFigure4) {
  Fed fed;
  EXPECT_EQ(fed.at_height(0.05, 10).phase, Phase::Released) << "waits its dwell before the first move";
  EXPECT_EQ(fed.at_height(0.05, 700).phase, Phase::BodyToPlane);
  EXPECT_EQ(fed.at_height(0.05, 700).phase, Phase::OutBody);
  EXPECT_EQ(fed.at_height(0.02, 1).phase, Phase::OutBody) << "S1: at least 0.3 s in each state";
  EXPECT_EQ(fed.at_height(0.02, 700).phase, Phase::PlaneToBody);
  EXPECT_EQ(fed.at_height(-0.001, 1).phase, Phase::InBody) << "the skin does not wait";
  EXPECT_EQ(fed.at_height(0.001, 1).phase, Phase::InBody);
  EXPECT_EQ(fed.at_height(0.001, 700).phase, Phase::BodyToPlane);
  EXPECT_EQ(fed.at_height(0.032, 700).phase, Phase::OutBody);
}

TEST(EncounteredController, AHandThatChattersAtTheSkinMakesNoLoop) {
  Fed fed;
  (void)fed.into_body();
  int changes = 0;
  for (int i = 0; i < 20'000; ++i) {  // 10 s of crossing the skin 1000 times a second
    const ControlOutput out = fed.at_height(i % 2 == 0 ? 0.0005 : -0.0005);
    if (out.phase != out.previous) ++changes;
  }
  EXPECT_LE(changes, 2 * 34) << "each stay in the body lasts 0.3 s, and only the way out waits";
}

TEST(EncounteredController, PushesBackTowardsTheBodyBeforeThePlaneIsReached) {
  Fed fed;
  (void)fed.into_body();
  EXPECT_EQ(fed.at_height(0.005, 10).phase, Phase::BodyToPlane);
  EXPECT_EQ(fed.at_height(-0.01, 700).phase, Phase::InBody);
}

TEST(EncounteredController, ForceOutOfTheBodyIsZeroOnceTheHandWaitsToBePushed) {
  Fed fed;
  (void)fed.at_height(0.05, 2000);
  EXPECT_EQ(fed.at_height(0.02, 2000).phase, Phase::PlaneToBody);
  EXPECT_EQ(fed.at_height(0.02, 1).force.N.norm(), 0.0);
}

TEST(EncounteredController, AStaleInputLetsGoWithinFiftyMilliseconds) {
  for (const int which : {0, 1, 2}) {
    SCOPED_TRACE(which);
    Fed fed;
    ASSERT_GT(fed.into_body().force.N.norm(), 0.9);
    double force_N = 0.0;
    for (int i = 0; i < 100; ++i) {  // 50 ms
      fed.in.contact = fed.skin(fed.in.device, 0.0);
      if (which == 0) fed.in.hand_age_s = 0.1001, fed.in.contact.in_body = false;
      if (which == 1) fed.in.contact.age_s = 1.0001;
      if (which == 2) fed.in.device_age_s = 0.1001;
      force_N = fed.controller.step(fed.in, 0.0005).force.N.norm();
    }
    EXPECT_EQ(force_N, 0.0);
    EXPECT_EQ(fed.controller.phase(), which == 2 ? Phase::Faulted : Phase::Released);
  }
}

TEST(EncounteredController, AReleasedDeviceGivesNoEnergyToAHandThatPressesOn) {
  Fed fed;
  ASSERT_GT(fed.into_body().force.N.norm(), 0.9);
  ControlOutput out;
  for (int i = 0; i < 1000; ++i) {  // 50 mm deeper in 0.5 s, on a surface above its age limit of 1 s
    fed.in.device.m.y() -= 5e-5;
    fed.in.contact = fed.skin(fed.in.device, 0.0);
    fed.in.contact.age_s = 1.0001;
    out = fed.controller.step(fed.in, 0.0005);
    ASSERT_LT(out.hand_excess_J, 1e-4) << i;
  }
  EXPECT_EQ(out.phase, Phase::Released);
  EXPECT_EQ(out.force.N.norm(), 0.0);
}

TEST(EncounteredController, ASilentDeviceCannotBeRearmedBeforeItAnswers) {
  Fed fed;
  (void)fed.into_body();
  fed.in.device_age_s = 0.2;
  ControlOutput out = fed.controller.step(fed.in, 0.0005);
  EXPECT_EQ(out.phase, Phase::Faulted);
  EXPECT_EQ(out.fault, control::FaultCause::DeviceSilent);
  fed.in.rearm = true;
  out = fed.controller.step(fed.in, 0.0005);
  EXPECT_EQ(out.phase, Phase::Faulted);
  EXPECT_EQ(out.fault_stands, control::FaultCause::DeviceSilent);
  fed.in.device_age_s = 0.0;
  out = fed.controller.step(fed.in, 0.0005);
  EXPECT_EQ(out.phase, Phase::Released);
  EXPECT_EQ(out.fault, control::FaultCause::None);
}

TEST(EncounteredController, ANaNFaultsUntilAnOperatorRearms) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int which : {0, 1, 2, 3, 4}) {
    SCOPED_TRACE(which);
    Fed fed;
    (void)fed.into_body();
    const control::ControlInput good = fed.in;
    if (which == 0) fed.in.device.m.x() = nan;
    if (which == 1) fed.in.device_velocity.v.y() = std::numeric_limits<double>::infinity();
    if (which == 2) fed.in.hand.m.z() = nan;
    if (which == 3) fed.in.contact.proxy.m.x() = nan;
    if (which == 4) fed.in.contact.normal.v.x() = -nan;
    EXPECT_EQ(fed.controller.step(fed.in, 0.0005).phase, Phase::Faulted);
    fed.in = good;
    ControlOutput out;
    for (int i = 0; i < 4000; ++i) out = fed.controller.step(fed.in, 0.0005);
    EXPECT_EQ(out.phase, Phase::Faulted);
    EXPECT_EQ(out.force.N.norm(), 0.0);
    fed.in.rearm = true;
    EXPECT_EQ(fed.controller.step(fed.in, 0.0005).phase, Phase::Released);
  }
}

}  // namespace
}  // namespace telepalp
