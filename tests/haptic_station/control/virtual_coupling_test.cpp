#include "haptic_station/control/safety/virtual_coupling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/device/random.h"
#include "haptic_station/trials/trial_run.h"
#include "haptic_station/trials/virtual_station.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

using effects::EffectInput;
using Eigen::Vector3d;

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

TEST(VirtualCoupling, ADeviceWithoutDampingShowsNoSpring) {
  EXPECT_EQ(stiffest_shown_N_per_m({.device_damping_N_s_per_m = 0.0}), 0.0);
}

constexpr double kStep_m = 1e-6;  // of the encoder

/// A device with damping `b` and mass `mass_kg`, without and with an arm, on a spring of `stiffness_N_per_m` that acts
/// on readings of `delay_ticks` ago and on encoders of 1 um. True: in 20 s, a displacement of `from_m` becomes larger
/// by more than an encoder step.
bool grows(double stiffness_N_per_m, double b, double mass_kg, int delay_ticks, double arm_N_per_m, double from_m) {
  constexpr int kParts = 20;  // of a tick, in which the device moves
  constexpr double kPart_s = 0.0005 / kParts;
  std::deque<double> read(static_cast<std::size_t>(delay_ticks), from_m);
  double at_m = from_m, speed = 0.0, most_m = 0.0;
  for (int tick = 0; tick < 40'000; ++tick) {
    read.push_back(std::round(at_m / kStep_m) * kStep_m);
    const double force_N = -stiffness_N_per_m * read.front();
    read.pop_front();
    for (int part = 0; part < kParts; ++part) {
      speed += (force_N - b * speed - arm_N_per_m * at_m) / mass_kg * kPart_s;
      at_m += speed * kPart_s;
    }
    most_m = std::max(most_m, std::abs(at_m));
    if (!(most_m < 1.0)) return true;
  }
  return most_m > from_m + kStep_m;
}

TEST(VirtualCoupling, AtAnyDelayNothingGrowsWithDampingAndDelayWrongBy30Percent) {
  for (const double delay_ms : {0.0, 0.5, 1.0, 2.0, 4.0})
    for (const double b : {0.3, 1.0, 3.0})
      for (const double mass_kg : {0.1, 0.3, 1.0})
        for (const double arm_N_per_m : {0.0, 300.0}) {
          // The station believes a damping that is 30 % too large, and a delay that is 30 % too small.
          const double shown_N_per_m =
              stiffest_shown_N_per_m({.device_damping_N_s_per_m = 1.3 * b, .loop_delay_s = 0.7e-3 * delay_ms});
          for (const double from_m : {kStep_m, 0.001})
            EXPECT_FALSE(grows(shown_N_per_m, b, mass_kg, static_cast<int>(2.0 * delay_ms), arm_N_per_m, from_m))
                << from_m << " m, " << delay_ms << " ms, b " << b << ", " << mass_kg << " kg, arm " << arm_N_per_m;
        }
}

TEST(VirtualCoupling, TheFloorThatItHadWouldSwingOnADelayOfFourMilliseconds) {
  EXPECT_TRUE(grows(400.0, 1.0, 0.3, 8, 0.0, kStep_m));
  EXPECT_FALSE(grows(stiffest_shown_N_per_m({.loop_delay_s = 0.004}), 1.0, 0.3, 8, 0.0, kStep_m));
}

/// A device pressed into a wall of 1200 N/m, and the coupling in a contact that lasts.
struct LastingContact {
  static constexpr double kWall_N_per_m = 1200.0;
  VirtualCoupling coupling{{}, kWall_N_per_m};
  double device_m = 0.0;
  double force_N = 0.0;
  double taken_J = 0.0;  ///< work of the hand
  double booked_J = 0.0;
  double wall_J = 0.0;
  double tool_m = 0.0;

  LastingContact() { coupling.begin({}); }
  /// One tick, as ForceControl does it.
  void tick(double moved_m) {
    taken_J -= force_N * moved_m;
    device_m += moved_m;
    EffectInput in;
    in.device.m.y() = device_m;
    in.moved.v.y() = moved_m;
    in.contact.normal = {Vector3d::UnitY()};
    coupling.soften(in);
    const double before_m = tool_m;
    if (coupling.engaged()) in = coupling.at_tool(in);
    tool_m = in.device.m.y();
    const Force<HapticBase> on_tool = wall(kWall_N_per_m, in.device);
    booked_J += coupling.engaged() ? coupling.absorbed_J() : 0.0;
    booked_J += 0.5 * kWall_N_per_m * (tool_m * tool_m - before_m * before_m);
    force_N = coupling.engaged() ? coupling.pull(on_tool).N.y() : on_tool.N.y();
    if (!coupling.engaged()) coupling.stand_by(on_tool);
  }
  [[nodiscard]] double stored_J() const {
    return 0.5 * kWall_N_per_m * tool_m * tool_m + (coupling.engaged() ? coupling.energy_J() : 0.0);
  }
};

TEST(VirtualCoupling, ADelayThatGrowsInAContactSoftensItWithoutAStepAndGivesNoEnergy) {
  LastingContact contact;
  EXPECT_FALSE(contact.coupling.engaged());
  for (int i = 0; i < 800; ++i) contact.tick(-1e-5);
  EXPECT_NEAR(contact.force_N, 9.6, 1e-9);
  double step_N = 0.0, last_N = contact.force_N;
  for (const double delay_s : {0.001, 0.004, 0.0}) {
    contact.coupling.delayed_by(delay_s);
    for (int i = 0; i < 2000; ++i) {
      contact.tick(0.0);
      step_N = std::max(step_N, std::abs(contact.force_N - last_N));
      last_N = contact.force_N;
    }
  }
  EXPECT_LT(step_N, 0.05);
  const double limit = stiffest_shown_N_per_m({.loop_delay_s = 0.004});
  EXPECT_NEAR(contact.coupling.stiffness_N_per_m(), limit, 1e-6) << "no stiffer under load";
  EXPECT_NEAR(contact.force_N, 0.008 * limit * 1200.0 / (limit + 1200.0), 1e-3);
  for (int i = 0; i < 800; ++i) contact.tick(1e-5);
  EXPECT_GT(contact.taken_J, 0.0) << "the hand gets less back than it gave";
  EXPECT_LE(contact.booked_J - contact.stored_J(), contact.taken_J)
      << "the ledger holds no energy that the spring lost";
  contact.coupling.begin({});
  EXPECT_FALSE(contact.coupling.engaged()) << "the next contact is rigid again";
}

}  // namespace
}  // namespace telepalp::control
