#include "haptic_station/tissue/fem/energy_tank.h"

#include <gtest/gtest.h>

#include "haptic_station/device/random.h"

namespace telepalp::tissue {
namespace {

TEST(EnergyTank, PaysNoMoreThanItHas) {
  EnergyTank tank(0.01, 0.02);
  EXPECT_DOUBLE_EQ(tank.pay(0.004), 0.004);
  EXPECT_DOUBLE_EQ(tank.pay(0.1), 0.006);
  EXPECT_EQ(tank.level_J(), 0.0);
  EXPECT_EQ(tank.pay(1.0), 0.0);
}

TEST(EnergyTank, HoldsNoMoreThanItsSizeAndSaysWhatWasLost) {
  EnergyTank tank(0.01, 0.02);
  tank.fill(0.05);
  EXPECT_DOUBLE_EQ(tank.level_J(), 0.02);
  EXPECT_DOUBLE_EQ(tank.lost_J(), 0.04);
  EXPECT_DOUBLE_EQ(EnergyTank(5.0, 0.02).level_J(), 0.02);
}

TEST(EnergyTank, TakesNothingForNegativeAmounts) {
  EnergyTank tank(0.01, 0.02);
  EXPECT_EQ(tank.pay(-1.0), 0.0);
  tank.fill(-1.0);
  EXPECT_DOUBLE_EQ(tank.level_J(), 0.01);
}

/// Whatever is paid and filled, no joule appears or is lost without a trace.
TEST(EnergyTank, BooksEveryJoule) {
  device::Random random(4);
  EnergyTank tank(0.01, 0.05);
  for (int i = 0; i < 100000; ++i) {
    const double J = 0.01 * random.uniform();
    if (random.uniform() < 0.5)
      (void)tank.pay(J);
    else
      tank.fill(J);
    ASSERT_GE(tank.level_J(), 0.0);
    ASSERT_LE(tank.level_J(), 0.05);
  }
  EXPECT_NEAR(0.01 + tank.filled_J() - tank.lost_J() - tank.paid_J(), tank.level_J(), 1e-9);
}

}  // namespace
}  // namespace telepalp::tissue
