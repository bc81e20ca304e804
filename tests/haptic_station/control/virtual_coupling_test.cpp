#include "haptic_station/control/safety/virtual_coupling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/device/random.h"
#include "haptic_station/trials/trial_run.h"
#include "haptic_station/trials/virtual_station.h"

namespace telepalp::control {
namespace {

using effects::EffectInput;
using Eigen::Vector3d;

constexpr double kTick_s = 0.0005;

/// The force of a wall at y = 0 on a point.
Force<HapticBase> wall(double stiffness_N_per_m, const Point<HapticBase>& at) {
  return {{0.0, stiffness_N_per_m * std::max(0.0, -at.m.y()), 0.0}};
}

/// Speed of a free device two seconds after a knock against a wall [m/s].
double speed_after_a_knock(double wall_N_per_m, double device_damping, bool coupled) {
  constexpr double kMass_kg = 0.3;
  VirtualCoupling coupling({.device_damping_N_s_per_m = device_damping}, wall_N_per_m);
  EXPECT_TRUE(coupling.engaged());
  double y = 0.0;
  double speed = -0.05;
  double late = 0.0;
  double moved = 0.0;
  coupling.begin({});
  for (int i = 0; i < 4000; ++i) {
    // A two-sided wall, the hardest case to stabilise.
    EffectInput in{
        .device = {{0.0, y, 0.0}}, .device_velocity = {{0.0, speed, 0.0}}, .contact = {}, .moved = {{0.0, moved, 0.0}}};
    in.contact.normal = {Vector3d::UnitY()};
    double force_N = -wall_N_per_m * y;
    if (coupled) {
      const EffectInput tool = coupling.at_tool(in);
      force_N = coupling.pull({{0.0, -wall_N_per_m * tool.device.m.y(), 0.0}}).N.y();
    }
    const double before = y;
    for (int k = 0; k < 20; ++k) {
      const double h = kTick_s / 20.0;
      speed += (force_N - device_damping * speed) / kMass_kg * h;
      y += speed * h;
    }
    moved = y - before;
    if (i >= 3000) late = std::max(late, std::abs(speed));
    if (!(std::abs(y) < 1e3)) return 1e9;
  }
  return late;
}

TEST(VirtualCoupling, StabilisesAWallThatIsTooStiffForTheDevice) {
  for (const double wall_N_per_m : {5'000.0, 29'000.0}) {
    EXPECT_GT(speed_after_a_knock(wall_N_per_m, 1.0, false), 0.05) << wall_N_per_m << ": without, it would not rest";
    EXPECT_LT(speed_after_a_knock(wall_N_per_m, 1.0, true), 0.02) << wall_N_per_m;
  }
}

TEST(VirtualCoupling, AtRestTheHandFeelsBothSpringsInSeries) {
  VirtualCoupling coupling({}, 8000.0);
  const double shown = coupling.stiffness_N_per_m();
  EXPECT_NEAR(shown, 2000.0, 1e-6);
  coupling.begin({});
  EffectInput in;
  in.device.m = {0.0, -0.001, 0.0};
  in.contact.normal = {Vector3d::UnitY()};
  double force_N = 0.0;
  for (int i = 0; i < 100; ++i) force_N = coupling.pull(wall(8000.0, coupling.at_tool(in).device)).N.y();
  EXPECT_NEAR(force_N, 0.001 * shown * 8000.0 / (shown + 8000.0), 1e-6);
}

TEST(VirtualCoupling, WithTheDeviceHeldStillTheEnergyOnlyFalls) {
  device::Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const double wall_N_per_m = random.uniform(2500.0, 40'000.0);
    VirtualCoupling coupling({}, wall_N_per_m);
    coupling.begin({{0.0, random.uniform(-0.01, 0.01), 0.0}});
    EffectInput in;
    in.device.m = {random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), 0.0};
    in.contact.normal = {Vector3d::UnitY()};
    double last_J = 1e9;
    for (int i = 0; i < 50; ++i) {
      const Point<HapticBase> tool = coupling.at_tool(in).device;
      (void)coupling.pull(wall(wall_N_per_m, tool));
      const double depth_m = std::max(0.0, -tool.m.y());
      const double energy_J = coupling.energy_J() + 0.5 * wall_N_per_m * depth_m * depth_m;
      ASSERT_LE(energy_J, last_J * (1.0 + 1e-12)) << trial << " at " << i;
      if (i > 0) last_J = energy_J;  // the tool does not start at the device, so the first step has no force yet
    }
  }
}

TEST(VirtualCoupling, TheContactIsThatOfTheTool) {
  VirtualCoupling coupling({}, 8000.0);
  coupling.begin({{0.0, -0.002, 0.0}});
  EffectInput in;
  in.device.m = {0.001, -0.004, 0.0};
  in.contact.normal = {Vector3d::UnitY()};
  in.contact.distance_m = -0.004;
  in.contact.proxy.m = {0.001, 0.0, 0.0};
  const EffectInput tool = coupling.at_tool(in);
  EXPECT_NEAR(tool.contact.distance_m, tool.device.m.y(), 1e-12);
  EXPECT_NEAR(tool.contact.proxy.m.x(), tool.device.m.x(), 1e-12);
  EXPECT_NEAR(tool.contact.proxy.m.y(), 0.0, 1e-12);
}

TEST(VirtualCoupling, StaysOutOfScenesThatTheDeviceCanShow) {
  trials::VirtualStationSettings with = trials::paper_settings();
  trials::VirtualStationSettings without = with;
  without.control.coupling.enabled = false;
  trials::VirtualStation a(with);
  trials::VirtualStation b(without);
  EXPECT_FALSE(a.controller().coupling().engaged());
  a.place({{0.0, 0.03, 0.0}}, {{0.0, 0.05, 0.0}});
  b.place({{0.0, 0.03, 0.0}}, {{0.0, 0.05, 0.0}});
  const auto presses = [](const device::TrialView& view) {
    return device::Intention{{{0.0, std::max(-0.05, 0.05 - 0.1 * view.time_s), 0.0}}, {}};
  };
  for (int i = 0; i < 4000; ++i) {
    const ControlOutput one = a.step(device::BreathingPlane{}, presses);
    const ControlOutput other = b.step(device::BreathingPlane{}, presses);
    ASSERT_EQ(one.force.N, other.force.N) << i;
  }
  EXPECT_TRUE(is_inside(a.controller().phase()));
}

TEST(VirtualCoupling, ADeviceWithoutFrictionStillShowsAForce) {
  EXPECT_EQ(stiffest_shown_N_per_m({.device_damping_N_s_per_m = 0.0}), 400.0);
}

}  // namespace
}  // namespace telepalp::control
