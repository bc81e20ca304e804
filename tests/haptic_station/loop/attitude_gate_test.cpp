#include "haptic_station/loop/attitude_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "proto/words/wrench.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::loop {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

ports::DeviceReading reading(const std::optional<Quaterniond>& attitude) {
  ports::DeviceReading one;
  one.attitude = attitude;
  one.turning.v = Vector3d(1.0, 0.0, 0.0);
  return one;
}
Quaterniond tilted(double rad) { return turned(Quaterniond::Identity(), {rad, 0.0, 0.0}); }

TEST(AttitudeGate, PassesAUnitQuaternionOfAnyReadableLength) {
  AttitudeGate gate;
  Quaterniond twice = tilted(0.3);
  twice.coeffs() *= 2.0;
  const Quaterniond out = gate.step(reading(twice), kTick_s).value_or(Quaterniond(0.0, 0.0, 0.0, 0.0));
  EXPECT_NEAR(out.norm(), 1.0, 1e-12);
  EXPECT_LT(out.angularDistance(tilted(0.3)), 1e-9);
  EXPECT_EQ(gate.turning(reading(twice)).v.x(), 1.0);
  EXPECT_FALSE(gate.step(reading(std::nullopt), kTick_s)) << "a device of three degrees";
}

TEST(AttitudeGate, BridgesNaNLengthZeroAndAJumpAndCountsEachOnce) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Quaterniond& wrong : {Quaterniond(nan, 0.0, 0.0, 1.0), Quaterniond(0.0, 0.0, 0.0, 0.0),
                                   Quaterniond(1e300, 0.0, 0.0, 1e300), tilted(2.0)}) {
    AttitudeGate gate;
    (void)gate.step(reading(tilted(0.3)), kTick_s);
    for (int tick = 0; tick < 8; ++tick) {
      const Quaterniond held = gate.step(reading(wrong), kTick_s).value_or(tilted(3.0));
      EXPECT_LT(held.angularDistance(tilted(0.3)), 1e-9);
      EXPECT_EQ(gate.turning(reading(wrong)).v, Vector3d::Zero());
    }
    EXPECT_EQ(gate.jumps(), 1U);
    EXPECT_LT(gate.step(reading(tilted(0.31)), kTick_s).value_or(tilted(3.0)).angularDistance(tilted(0.31)), 1e-9);
  }
}

TEST(AttitudeGate, CountsAsNotMeasuredAfter20msWithoutARotationAndTakesALastingOneAsItIs) {
  AttitudeGate gate;
  (void)gate.step(reading(tilted(0.3)), kTick_s);
  int held = 0;
  while (held < 1000 && gate.step(reading(Quaterniond(0.0, 0.0, 0.0, 0.0)), kTick_s)) ++held;
  EXPECT_NEAR(held * kTick_s, 0.02, 0.001);
  EXPECT_TRUE(gate.step(reading(tilted(1.0)), kTick_s)) << "measured again";
  Quaterniond last = Quaterniond::Identity();
  for (int tick = 0; tick < 50; ++tick)
    last = gate.step(reading(tilted(2.5)), kTick_s).value_or(Quaterniond::Identity());
  EXPECT_LT(last.angularDistance(tilted(2.5)), 1e-9) << "an offset that lasts";
}

}  // namespace
}  // namespace telepalp::loop
