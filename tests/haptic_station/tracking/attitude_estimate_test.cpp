#include "haptic_station/tracking/attitude_estimate.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "haptic_station/tracking/hand_axes.h"
#include "tests/haptic_station/tracking/at_s.h"
#include "tests/haptic_station/tracking/straight_on.h"

namespace telepalp::tracking {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond about(const Vector3d& axis, double angle_rad) {
  return Quaterniond(Eigen::AngleAxisd(angle_rad, axis.normalized()));
}

TEST(HandAxes, ALeapHandWithThePalmDownHasItsBackUpAndItsLittleFingerToTheRight) {
  const auto attitude = hand_axes({0.0, 0.0, -1.0}, {0.0, -1.0, 0.0});  // Leap: y up, z to the user
  ASSERT_TRUE(attitude);
  EXPECT_LT((*attitude * Vector3d::UnitX() - Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((*attitude * Vector3d::UnitY() + Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((*attitude * Vector3d::UnitZ() - Vector3d::UnitY()).norm(), 1e-12);
}

TEST(HandAxes, DirectionsThatSayNothingGiveNoAttitude) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(hand_axes({0.0, 0.0, 0.0}, {0.0, -1.0, 0.0}));
  EXPECT_FALSE(hand_axes({0.0, -1.0, 0.01}, {0.0, -1.0, 0.0}));
  EXPECT_FALSE(hand_axes({nan, 0.0, 0.0}, {0.0, -1.0, 0.0}));
}

TEST(AttitudeEstimate, FollowsATurnOfManyRevolutionsBetweenSamples) {
  AttitudeEstimate estimate;
  const Vector3d axis(0.3, -0.5, 0.8);
  for (int i = 0; i < 500; ++i) {
    // Both signs of a quaternion are the same rotation.
    Quaterniond sample = about(axis, 0.06 * i);
    if (i % 3 == 0) sample.coeffs() *= -1.0;
    EXPECT_NE(estimate.update(at_s(0.01 * i), sample), Taken::Jump);
  }
  const auto ahead = estimate.predict(at_s(0.01 * 499 + 0.02));
  ASSERT_TRUE(ahead);
  EXPECT_LT(ahead->angularDistance(about(axis, 0.06 * 501)), 0.01);
}

TEST(AttitudeEstimate, RefusesWhatIsNoRotationAndForgetsAnOldOne) {
  AttitudeEstimate estimate;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(estimate.predict(at_s(0.0)));
  EXPECT_EQ(estimate.update(at_s(0.0), Quaterniond(0.0, 0.0, 0.0, 0.0)), Taken::NotFinite);
  EXPECT_EQ(estimate.update(at_s(0.0), Quaterniond(nan, 0.0, 0.0, 1.0)), Taken::NotFinite);
  EXPECT_FALSE(estimate.predict(at_s(0.0)));
  (void)estimate.update(at_s(0.0), Quaterniond(2.0, 0.0, 0.0, 0.0));
  ASSERT_TRUE(estimate.predict(at_s(0.5)));
  EXPECT_NEAR(estimate.predict(at_s(0.5))->norm(), 1.0, 1e-12);
  EXPECT_FALSE(estimate.predict(at_s(1.5)));
}

struct Errors {
  double estimate_square = 0.0;
  double held_square = 0.0;
  double line_square = 0.0;
};

/// Predicts each `every`-th attitude of the trace from those before it; the truth is the next such sample.
Errors predict_next(const HandTrace& trace, std::size_t every) {
  AttitudeEstimate estimate;
  Errors errors;
  const auto& all = trace.samples;
  for (std::size_t i = 0; i + every < all.size(); i += every) {
    (void)estimate.update(all[i].at, *all[i].attitude);
    if (i < 5 * every || to_seconds(all[i + every].at - all[i - every].at) > 0.1) continue;
    const Quaterniond& truth = *all[i + every].attitude;
    const double share = to_seconds(all[i + every].at - all[i].at) / to_seconds(all[i].at - all[i - every].at);
    const Eigen::AngleAxisd turn(all[i - every].attitude->conjugate() * *all[i].attitude);
    const double turn_rad = std::remainder(turn.angle(), 2.0 * std::numbers::pi);
    const Quaterniond line = *all[i].attitude * Quaterniond(Eigen::AngleAxisd(share * turn_rad, turn.axis()));
    const auto squared = [&](const Quaterniond& said) { return std::pow(said.angularDistance(truth), 2.0); };
    errors.estimate_square += squared(*estimate.predict(all[i + every].at));
    errors.held_square += squared(*all[i].attitude);
    errors.line_square += squared(line);
  }
  return errors;
}

TEST(AttitudeEstimate, OnRecordedHandsIsNoWorseThanHoldingOrTurningOn) {
  int traces = 0;
  for (const auto& file : testing::recorded_hands()) {
    const Result<HandTrace> trace = read_hand_trace(file);
    ASSERT_TRUE(trace.ok()) << to_string(trace.error());
    if (!trace->samples.front().attitude) continue;
    ++traces;
    for (const std::size_t every : {1U, 2U}) {
      const Errors errors = predict_next(*trace, every);
      const double best = std::min(errors.held_square, errors.line_square);
      std::printf("%s, each %zu.: %.3f of holding, %.3f of turning on\n", file.stem().c_str(), every,
                  std::sqrt(errors.estimate_square / errors.held_square),
                  std::sqrt(errors.estimate_square / errors.line_square));
      EXPECT_LE(std::sqrt(errors.estimate_square / best), 1.02) << file << ", each " << every << ". sample";
    }
  }
  EXPECT_GE(traces, 4);
}

}  // namespace
}  // namespace telepalp::tracking
