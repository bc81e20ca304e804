#include "haptic_station/control/parts/transition_fade.h"

#include <gtest/gtest.h>

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

TEST(TransitionFade, PassesAForceThatDoesNotBreak) {
  TransitionFade fade;
  EXPECT_EQ(fade.step(Vector3d(0.0, 2.0, 0.0), false, 40.0, 0.0005), Vector3d(0.0, 2.0, 0.0));
}

TEST(TransitionFade, LetsTheOldForceGoAtItsRateAndNotLonger) {
  TransitionFade fade;
  (void)fade.step(Vector3d(0.0, 2.0, 0.0), false, 40.0, 0.0005);
  const Vector3d zero = Vector3d::Zero();
  double before_N = 2.0;
  Vector3d force_N = fade.step(zero, true, 40.0, 0.0005);
  for (int tick = 1; tick < 100; ++tick) {
    EXPECT_NEAR(before_N - force_N.y(), 0.02, 1e-9) << tick;
    before_N = force_N.y();
    force_N = fade.step(zero, false, 40.0, 0.0005);
  }
  EXPECT_NEAR(force_N.y(), 0.0, 1e-9) << "2 N at 40 N/s: 50 ms";
}

TEST(TransitionFade, ABreakDuringAFadeStartsFromTheForceOfTheLastTick) {
  TransitionFade fade;
  (void)fade.step(Vector3d(0.0, 2.0, 0.0), false, 40.0, 0.0005);
  const Vector3d before_N = fade.step(Vector3d::Zero(), true, 40.0, 0.0005);
  const Vector3d after_N = fade.step(Vector3d(5.0, 0.0, 0.0), true, 40.0, 0.0005);
  EXPECT_NEAR((after_N - before_N).norm(), 0.02, 1e-9);
}

}  // namespace
}  // namespace telepalp::control
