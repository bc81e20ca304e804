#include "haptic_station/loop/device_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/haptic_station/periods.h"

namespace telepalp::loop {
namespace {

/// A device that moves up and down by 10 mm at 1 Hz, with a gate for its readings.
struct GateBench {
  DeviceGate gate;
  int tick = 0;
  [[nodiscard]] double true_m(int at) const { return 0.01 * std::sin(2.0 * 3.14159265358979 * at * kTick_s); }
  GatedReading step(double off_m) {
    ports::DeviceReading reading;
    reading.at.m.y() = true_m(tick) + off_m;
    reading.velocity.v.y() = (true_m(tick) - true_m(tick - 1)) / kTick_s;
    ++tick;
    return gate.step(reading, kTick_s);
  }
  GatedReading run(int ticks, double off_m = 0.0) {
    GatedReading last;
    for (int i = 0; i < ticks; ++i) last = step(off_m);
    return last;
  }
  [[nodiscard]] double error_m(const GatedReading& got) const { return std::abs(got.at.m.y() - true_m(tick - 1)); }
};

TEST(DeviceGate, PassesPlausibleReadings) {
  GateBench bench;
  for (int i = 0; i < 4000; ++i) EXPECT_LT(bench.error_m(bench.step(0.0)), 1e-12);
  EXPECT_EQ(bench.gate.jumps(), 0U);
}

TEST(DeviceGate, BridgesOneReadingThatIsOff) {
  for (const double off_m : {0.0003, -0.0003, 0.002, 0.3}) {
    GateBench bench;
    (void)bench.run(777);
    const GatedReading off = bench.step(off_m);
    EXPECT_LT(bench.error_m(off), 2e-5) << off_m;
    EXPECT_GT(off.implausible_s, 0.0);
    const GatedReading after = bench.step(0.0);
    EXPECT_LT(bench.error_m(after), 1e-6) << off_m;
    EXPECT_EQ(after.implausible_s, 0.0);
    EXPECT_EQ(bench.gate.jumps(), 1U);
  }
}

TEST(DeviceGate, AbsorbsASmallLastingSlipWithoutAStep) {
  GateBench bench;
  (void)bench.run(777);
  double before_m = bench.step(0.0).at.m.y();
  double step_m = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const GatedReading got = bench.step(0.002);
    step_m = std::max(step_m, std::abs(got.at.m.y() - before_m));
    before_m = got.at.m.y();
  }
  EXPECT_LT(step_m, 0.3 * kTick_s) << "0.06 m/s of its own, and 0.15 m/s of the slip";
  EXPECT_NEAR(bench.error_m(bench.step(0.002)), 0.002, 1e-6) << "then the readings are followed";
}

TEST(DeviceGate, ALargeLastingOffsetStaysImplausibleUntilItIsAccepted) {
  GateBench bench;
  (void)bench.run(777);
  const GatedReading held = bench.run(40, 0.03);
  EXPECT_NEAR(held.implausible_s, 0.02, 1e-9);
  EXPECT_LT(bench.error_m(held), 0.002);
  EXPECT_EQ(bench.run(1100, 0.03).implausible_s, 0.0) << "so that an operator can re-arm";
}

TEST(DeviceGate, ASuddenMovementIsFollowedAtOnceAndItsSlipIsAbsorbedWithinATenthOfASecond) {
  DeviceGate gate;
  ports::DeviceReading reading;
  GatedReading got;
  for (int tick = 0; tick < 100; ++tick) got = gate.step(reading, kTick_s);
  reading.velocity.v.y() = -1.0;  // from rest to 1 m/s in a tick
  for (int tick = 0; tick < 200; ++tick) {
    reading.at.m.y() -= 1.0 * kTick_s;
    got = gate.step(reading, kTick_s);
    EXPECT_LT(got.implausible_s, 0.003);
  }
  EXPECT_NEAR(got.at.m.y(), reading.at.m.y(), 1e-4);
}

TEST(DeviceGate, ADeviceThatAnswersEveryOtherTickIsNotJumping) {
  DeviceGate gate;
  ports::DeviceReading reading;
  reading.velocity.v.y() = 0.5;
  for (int tick = 0; tick < 2000; ++tick) {
    reading.age_s = tick % 2 == 0 ? 0.0 : kTick_s;
    if (tick % 2 == 0) reading.at.m.y() = 0.5 * tick * kTick_s;
    EXPECT_EQ(gate.step(reading, kTick_s).implausible_s, 0.0) << tick;
  }
}

TEST(DeviceGate, GoesOnWhereAReadingIsNoNumber) {
  for (const double broken : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    DeviceGate gate;
    ports::DeviceReading reading;
    reading.velocity.v.y() = -0.1;
    double before_m = 0.0;
    for (int tick = 0; tick < 400; ++tick) {
      reading.at.m.y() = -0.1 * tick * kTick_s;
      ports::DeviceReading given = reading;
      const bool breaks = tick >= 200 && tick < 216;
      if (breaks) given.at.m.z() = broken;
      const GatedReading got = gate.step(given, kTick_s);
      ASSERT_TRUE(got.at.m.allFinite() && got.velocity.v.allFinite());
      EXPECT_NEAR(got.unreadable_s, breaks ? (tick - 199) * kTick_s : 0.0, 1e-12);
      EXPECT_EQ(got.implausible_s, 0.0);
      EXPECT_LT(std::abs(got.at.m.y() - before_m), 1.5e-4) << tick;
      before_m = got.at.m.y();
    }
    EXPECT_NEAR(before_m, reading.at.m.y(), 1e-5) << "the slip is removed within a tenth of a second";
  }
}

TEST(DeviceGate, ADeviceThatNeverSentANumberStaysUnreadable) {
  DeviceGate gate;
  ports::DeviceReading reading;
  reading.age_s = std::numeric_limits<double>::quiet_NaN();
  const GatedReading got = gate.step(reading, kTick_s);
  EXPECT_TRUE(got.at.m.isZero());
  EXPECT_TRUE(std::isinf(got.unreadable_s));
}

}  // namespace
}  // namespace telepalp::loop
