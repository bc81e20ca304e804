#include "haptic_station/control/parts/energy_account.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

constexpr double kBound_N = 10.0;

/// A tick in which the device moves 0.1 mm outwards and the effects give `gave_J` more than they stored.
Exchange outwards(double gave_J) {
  Exchange exchange;
  exchange.absorbed_J = -gave_J;
  exchange.moved.v = Vector3d(0.0, 1e-4, 0.0);
  exchange.velocity.v = exchange.moved.v / kTick_s;
  return exchange;
}

TEST(EnergyAccount, ShowsTheAskedForceWithoutAnExcessOfEnergy) {
  EnergyAccount account;
  account.begin();
  EXPECT_EQ(account.step({{Vector3d(0.0, 3.0, 0.0)}}, 1.0, {}, kBound_N, kTick_s).force.N, Vector3d(0.0, 3.0, 0.0));
  EXPECT_FALSE(account.withholds());
}

TEST(EnergyAccount, DampsEnergyThatTheHandDidNotPutIn) {
  EnergyAccount account;
  account.begin();
  Vector3d force_N = Vector3d::Zero();
  for (int tick = 0; tick < 10; ++tick)
    force_N = account.step({{Vector3d(0.0, 3.0, 0.0)}}, 1.0, outwards(1e-4), kBound_N, kTick_s).force.N;
  EXPECT_LT(account.passivity().balance_J(), 0.0);
  EXPECT_LT(force_N.y(), 3.0);
  EXPECT_LT(account.damping().N.y(), 0.0) << "against the movement";
}

/// A newer surface may change the effects' force in one tick. The damping changes less in this tick, so
/// that both together make a smaller step.
TEST(EnergyAccount, TheDampingChangesSlowlyInATickInWhichTheEffectsForceSteps) {
  const auto damping_after = [](double steps_N) {
    EnergyAccount account;
    account.begin();
    (void)account.step({{Vector3d(0.0, 3.0, 0.0)}}, 1.0, {}, kBound_N, kTick_s);
    double before_N = 0.0;
    double most_N = 0.0;
    for (int tick = 1; tick < 20; ++tick) {
      (void)account.step({{Vector3d(0.0, 3.0 + steps_N * tick, 0.0)}}, 1.0, outwards(1e-3), kBound_N, kTick_s);
      most_N = std::max(most_N, std::abs(account.damping().N.y() - before_N));
      before_N = account.damping().N.y();
    }
    return most_N;
  };
  EXPECT_NEAR(damping_after(0.0), 0.045, 1e-9);
  EXPECT_NEAR(damping_after(0.015), 0.03, 1e-9);
  EXPECT_NEAR(damping_after(0.075), 0.02, 1e-9);
}

TEST(EnergyAccount, BooksTheForceThatTheDeviceCannotGive) {
  EnergyAccount account;
  account.begin();
  EXPECT_EQ(account.step({{Vector3d(0.0, 25.0, 0.0)}}, 1.0, {}, kBound_N, kTick_s).force.N, Vector3d(0.0, 10.0, 0.0));
  EXPECT_TRUE(account.withholds());
  // The effects ask for 25 N over 0.1 mm, the device gives 10 N: 1.5 mJ are not given.
  (void)account.step({}, 1.0, outwards(25.0 * 1e-4), kBound_N, kTick_s);
  EXPECT_NEAR(account.passivity().balance_J(), -10.0 * 1e-4, 1e-12);
}

TEST(EnergyAccount, ShowsTheShareOfAContactThatIsReleased) {
  EnergyAccount account;
  account.begin();
  EXPECT_EQ(account.step({{Vector3d(0.0, 4.0, 0.0)}}, 0.25, {}, kBound_N, kTick_s).force.N, Vector3d(0.0, 1.0, 0.0));
  EXPECT_TRUE(account.withholds());
}

TEST(EnergyAccount, BooksTheForceThatTheLimiterRemoved) {
  EnergyAccount account;
  account.begin();
  (void)account.step({{Vector3d(0.0, 4.0, 0.0)}}, 1.0, {}, kBound_N, kTick_s);
  account.limited({{Vector3d(0.0, 1.0, 0.0)}}, {{Vector3d(0.0, 4.0, 0.0)}});
  EXPECT_TRUE(account.withholds());
  (void)account.step({}, 1.0, outwards(4.0 * 1e-4), kBound_N, kTick_s);
  EXPECT_NEAR(account.passivity().balance_J(), -1e-4, 1e-12);
}

}  // namespace
}  // namespace telepalp::control
