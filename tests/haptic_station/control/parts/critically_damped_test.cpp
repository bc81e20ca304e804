#include "haptic_station/control/parts/critically_damped.h"

#include <gtest/gtest.h>

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

TEST(CriticallyDamped, OneLongStepIsAsGoodAsManyShortOnes) {
  const Moving start{{0.02, 0.0, -0.01}, {0.0, 0.5, 0.1}};
  Moving many = start;
  for (int step = 0; step < 1000; ++step) many = toward_zero(many, 25.0, 0.0001);
  const Moving one = toward_zero(start, 25.0, 0.1);
  EXPECT_LT((many.m - one.m).norm(), 1e-12);
  EXPECT_LT((many.per_s - one.per_s).norm(), 1e-11);
}

TEST(CriticallyDamped, DoesNotOvershootFromRest) {
  Moving moving{{0.02, 0.0, 0.0}, Vector3d::Zero()};
  for (int step = 0; step < 2000; ++step) {
    moving = toward_zero(moving, 25.0, 0.0005);
    EXPECT_GE(moving.m.x(), 0.0);
  }
  EXPECT_LT(moving.m.x(), 1e-9);
}

TEST(Shortened, KeepsTheDirection) {
  EXPECT_EQ(at_most(Vector3d(0.0, 4.0, 0.0), 1.0), Vector3d(0.0, 1.0, 0.0));
  EXPECT_EQ(at_most(Vector3d(0.0, 0.5, 0.0), 1.0), Vector3d(0.0, 0.5, 0.0));
}

}  // namespace
}  // namespace telepalp::control
