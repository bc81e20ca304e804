#include "haptic_station/tracking/hand_estimate.h"

#include <gtest/gtest.h>

#include <limits>

#include "haptic_station/device/random.h"

namespace telepalp::tracking {
namespace {

SessionTime at_s(double seconds) { return SessionTime{from_seconds(seconds)}; }

Point<HapticBase> swing(double t) { return {{0.1 * std::sin(4.0 * t), 0.05 * std::cos(3.0 * t), 0.02 * t}}; }

TEST(HandEstimate, FollowsASwingBetweenUpdatesDespiteJitter) {
  device::Random random(3);
  HandEstimate estimate;
  double worst_m = 0.0;
  double next_sample_s = 0.0;
  for (double t = 0.0; t < 5.0; t += 0.0005) {
    if (t >= next_sample_s) {
      (void)estimate.update(at_s(t), swing(t));
      next_sample_s += 0.01 + random.uniform(-0.004, 0.004);
    }
    if (t > 0.5) worst_m = std::max(worst_m, (estimate.predict(at_s(t)).at.m - swing(t).m).norm());
  }
  EXPECT_LT(worst_m, 0.0008);
}

TEST(HandEstimate, RefusesAndCountsInvalidSamples) {
  HandEstimate estimate;
  EXPECT_EQ(estimate.update(at_s(1.0), {{0.0, 0.0, 0.0}}), Taken::Restarted);
  EXPECT_EQ(estimate.update(at_s(1.01), {{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}}), Taken::NotFinite);
  EXPECT_EQ(estimate.update(at_s(1.0), {{0.0, 0.0, 0.0}}), Taken::OutOfOrder);
  EXPECT_EQ(estimate.update(at_s(0.5), {{0.0, 0.0, 0.0}}), Taken::OutOfOrder);
  EXPECT_EQ(estimate.update(at_s(1.02), {{0.7, 0.0, 0.0}}), Taken::Outlier);
  EXPECT_EQ(estimate.refused(), 4U);
}

TEST(HandEstimate, AnotherHandIsBelievedWhenItStays) {
  HandEstimate estimate;
  (void)estimate.update(at_s(0.0), {{0.0, 0.0, 0.0}});
  Taken taken = Taken::Used;
  int samples = 0;
  for (double t = 0.01; taken != Taken::Restarted && samples < 20; t += 0.01, ++samples)
    taken = estimate.update(at_s(t), {{0.5, 0.0, 0.0}});
  EXPECT_EQ(taken, Taken::Restarted);
  EXPECT_LE(samples, 6);
}

TEST(HandEstimate, DoesNotFlyOffInAGapAndItsUncertaintyIsBounded) {
  HandEstimate estimate;
  for (double t = 0.0; t < 1.0; t += 0.01) (void)estimate.update(at_s(t), {{0.5 * t, 0.0, 0.0}});
  const HandPrediction soon = estimate.predict(at_s(1.04));
  const HandPrediction late = estimate.predict(at_s(60.0));
  EXPECT_NEAR(soon.at.m.x(), 0.52, 0.01) << "the velocity dies away ahead of the samples";
  EXPECT_NEAR(late.at.m.x(), 0.52, 0.02);
  EXPECT_EQ(late.velocity.v.norm(), 0.0);
  EXPECT_LT(late.sigma_m, 0.1);
  EXPECT_NEAR(late.age_s, 59.01, 0.02);
}

TEST(HandEstimate, WithoutASampleItIsNotValid) { EXPECT_FALSE(HandEstimate().predict(at_s(1.0)).valid); }

}  // namespace
}  // namespace telepalp::tracking
