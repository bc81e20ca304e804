#include "haptic_station/tracking/hand_estimate.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "haptic_station/device/random.h"
#include "tests/haptic_station/tracking/at_s.h"
#include "tests/haptic_station/tracking/straight_on.h"

namespace telepalp::tracking {
namespace {

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
  EXPECT_EQ(estimate.update(at_s(1.02), {{0.7, 0.0, 0.0}}), Taken::Jump);
  EXPECT_EQ(estimate.refused(), 4U);
}

/// Samples at 100 Hz from `from_s` to `to_s`, offset by `off_m(t)`; the last answer.
Taken feed(HandEstimate& estimate, double from_s, double to_s, const std::function<double(double)>& off_m) {
  Taken taken = Taken::Used;
  for (double t = from_s; t < to_s; t += 0.01) taken = estimate.update(at_s(t), {{0.3 * t + off_m(t), 0.0, 0.0}});
  return taken;
}

TEST(HandEstimate, AJumpIsHeldAndBelievedOnlyAfterHalfASecondOfAgreement) {
  HandEstimate estimate;
  (void)feed(estimate, 0.0, 1.0, [](double) { return 0.0; });
  EXPECT_EQ(feed(estimate, 1.0, 1.4, [](double) { return 0.3; }), Taken::Jump);
  EXPECT_NEAR(estimate.predict(at_s(1.4)).implausible_s, 0.4, 0.011);
  EXPECT_NEAR(estimate.predict(at_s(1.4)).at.m.x(), 0.3, 0.02) << "the estimate stays where it was believed";
  EXPECT_EQ(feed(estimate, 1.4, 1.6, [](double) { return 0.3; }), Taken::Used);
  EXPECT_EQ(estimate.predict(at_s(1.6)).implausible_s, 0.0) << "so that an operator can re-arm";
  EXPECT_NEAR(estimate.predict(at_s(1.6)).at.m.x(), 0.3 * 1.6 + 0.3, 0.01);
}

TEST(HandEstimate, CountsASampleAsRefusedOnlyIfItIsNotUsed) {
  HandEstimate estimate;
  std::uint64_t jumps = 0;
  for (int i = 0; i < 200; ++i)
    if (estimate.update(at_s(0.01 * i), {{i < 100 ? 0.0 : 0.3, 0.0, 0.0}}) == Taken::Jump) ++jumps;
  EXPECT_GT(jumps, 45U);
  EXPECT_EQ(estimate.refused(), jumps) << "the sample that is believed after the jump is not refused";
}

TEST(HandEstimate, JumpsThatDisagreeAreNeverBelieved) {
  HandEstimate estimate;
  (void)feed(estimate, 0.0, 1.0, [](double) { return 0.0; });
  const auto all_over = [](double t) { return std::fmod(t, 0.02) < 0.01 ? 0.9 : -0.9; };
  EXPECT_EQ(feed(estimate, 1.0, 3.0, all_over), Taken::Jump);
  EXPECT_GT(estimate.predict(at_s(3.0)).implausible_s, 1.9);
  EXPECT_EQ(feed(estimate, 3.0, 3.02, [](double) { return -0.59; }), Taken::Used) << "back where it was: at once";
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

TEST(HandEstimate, IsNeverWorseThanStraightOnAtAnyRateHorizonOrNoise) {
  for (const auto& file : testing::recorded_hands()) {
    const Result<HandTrace> trace = read_hand_trace(file);
    ASSERT_TRUE(trace.ok()) << to_string(trace.error());
    for (const std::size_t every : {1U, 2U})
      for (const double noise_m : {0.0, 0.0002, 0.001, 0.003})
        EXPECT_LE(testing::worst_ratio_to_straight_on(*trace, every, noise_m), 1.02)
            << file << ", each " << every << ". sample, noise of " << 1e3 * noise_m << " mm";
  }
}

TEST(HandEstimate, AveragesTheNoiseOfATrackerThatHasSome) {
  for (const auto& file : testing::recorded_hands()) {
    const Result<HandTrace> trace = read_hand_trace(file);
    ASSERT_TRUE(trace.ok()) << to_string(trace.error());
    EXPECT_LE(testing::ratio_to_straight_on(*trace, 1, 0.02, 0.003), 0.65) << file;
  }
}

TEST(HandEstimate, FindsTheTrackersNoiseAtAnyRate) {
  for (const double noise_m : {0.0, 0.0003, 0.002})
    for (const double rate_hz : {30.0, 100.0, 200.0}) {
      device::Random random(5);
      HandEstimate estimate;
      for (double t = 0.0; t < 8.0; t += (1.0 + random.uniform(-0.3, 0.3)) / rate_hz) {
        const Eigen::Vector3d noise{random.normal(), random.normal(), random.normal()};
        (void)estimate.update(at_s(t), {swing(t).m + noise_m * noise});
      }
      const double tolerance_m = 0.3 * noise_m + (rate_hz < 50.0 ? 0.0003 : 0.00003);
      EXPECT_NEAR(estimate.noise_m(), noise_m, tolerance_m) << rate_hz << " Hz";
    }
}

TEST(HandEstimate, KeepsTheVelocityOfASweepAndNotThatOfAPoke) {
  HandEstimate sweep;
  for (double t = 0.0; t < 2.0; t += 0.01) (void)sweep.update(at_s(t), {{0.3 * t, 0.0, 0.0}});
  EXPECT_NEAR(sweep.predict(at_s(2.04)).at.m.x(), 0.3 * 2.04, 0.0003);
  HandEstimate pokes;  // 20 mm in 40 ms, four times a second
  const auto poke = [](double t) {
    return 0.02 * std::clamp(std::fmod(t, 0.25) / 0.04, 0.0, 1.0) + 0.02 * std::floor(t / 0.25);
  };
  double t = 0.0;
  for (; t < 2.025; t += 0.01) (void)pokes.update(at_s(t), {{poke(t), 0.0, 0.0}});
  const double ahead_m = pokes.predict(at_s(t + 0.04)).at.m.x() - poke(t - 0.01);
  EXPECT_LT(ahead_m, 0.7 * 0.05 * 0.5) << "a hand that always stops after 40 ms is not carried on";
}

TEST(HandEstimate, WithoutASampleItIsNotValid) { EXPECT_FALSE(HandEstimate().predict(at_s(1.0)).valid); }

}  // namespace
}  // namespace telepalp::tracking
