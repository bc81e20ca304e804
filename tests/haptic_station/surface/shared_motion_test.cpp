#include "haptic_station/surface/temporal/shared_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "tests/haptic_station/periods.h"

namespace telepalp::surface {
namespace {

constexpr double kCellSigma_m = 1e-4;  // of a cell's mean
constexpr double kSwing_rad_per_s = 3.0;
constexpr std::size_t kCells = 200;

double share_of(std::size_t cell) { return 0.2 + 0.8 * static_cast<double>(cell) / kCells; }

/// A body whose cells move by their shares of `moved_m(t)`. The frames are compared with what `motion` predicts.
SharedMotion followed(const std::function<double(double)>& moved_m, double until_s, std::size_t strangers = 0) {
  SharedMotion motion(kCells);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, kCellSigma_m);
  std::vector<SharedInnovation> seen(kCells);
  std::vector<SharedPrediction> predicted(kCells);
  std::vector<float> measured_m(kCells);
  std::vector<double> expected_m(kCells, 0.0);
  for (double t = 0.0; t < until_s; t += kFrame_s) {
    const double speed = motion.speed_m_per_s();
    const double acceleration = motion.acceleration_m_per_s2();
    const double angle = kSwing_rad_per_s * kFrame_s;
    const double ahead_m = speed * std::sin(angle) / kSwing_rad_per_s +
                           acceleration * (1.0 - std::cos(angle)) / (kSwing_rad_per_s * kSwing_rad_per_s);
    const SharedPrediction next{ahead_m, speed * std::cos(angle) + acceleration * std::sin(angle) / kSwing_rad_per_s,
                                acceleration * std::cos(angle) - speed * kSwing_rad_per_s * std::sin(angle)};
    for (std::size_t i = 0; i < kCells; ++i)
      predicted[i] = {motion.share(i) * next.change_m, motion.share(i) * next.speed_m_per_s,
                      motion.share(i) * next.acceleration_m_per_s2};
    motion.predict(predicted, kFrame_s, kSwing_rad_per_s);
    for (std::size_t i = 0; i < kCells; ++i) {
      expected_m[i] += motion.share(i) * ahead_m;
      const double stranger_m = i < strangers ? 0.005 * std::sin(9.0 * t) : 0.0;
      const double at_m = share_of(i) * moved_m(t) + noise(random) + stranger_m;
      seen[i] = {at_m - expected_m[i], kCellSigma_m};
      measured_m[i] = static_cast<float>(at_m);
    }
    motion.correct(seen, kFrame_s);
    // The cells' own filters follow what is left, as in MotionField.
    for (std::size_t i = 0; i < kCells; ++i) {
      const double own_m = seen[i].m - motion.share(i) * motion.innovation_m();
      expected_m[i] += motion.share(i) * motion.corrected_m() + 0.2 * own_m;
    }
    motion.learn(measured_m, kFrame_s);
  }
  return motion;
}

double breath_m(double t) { return 0.0025 * (1.0 - std::cos(1.6 * t)); }
double breath_m_per_s(double t) { return 0.0025 * 1.6 * std::sin(1.6 * t); }

/// The speed of one cell from two frames has a standard deviation of 4 mm/s.
TEST(SharedMotion, SpeedIsFarMoreAccurateThanThatOfOneCell) {
  for (const double until_s : {9.0, 9.7, 10.4, 11.1}) {
    const SharedMotion motion = followed(breath_m, until_s);
    const std::size_t cell = kCells - 1;
    EXPECT_NEAR(motion.share(cell) * motion.speed_m_per_s(), share_of(cell) * breath_m_per_s(until_s), 7e-4)
        << "at " << until_s << " s";
  }
}

TEST(SharedMotion, CellsThatMoveByThemselvesHardlyDisturbIt) {
  const SharedMotion motion = followed(breath_m, 10.4, kCells / 10);
  const std::size_t cell = kCells - 1;
  EXPECT_NEAR(motion.share(cell) * motion.speed_m_per_s(), share_of(cell) * breath_m_per_s(10.4), 2e-3);
}

TEST(SharedMotion, AShiftIsToldAsUnmodelledForASecondAndABreathIsNot) {
  const auto shifted_m = [](double t) {
    const double x = std::clamp((t - 12.0) / 0.2, 0.0, 1.0);
    return breath_m(t) + 0.01 * x * x * (3.0 - 2.0 * x);
  };
  for (const double until_s : {6.0, 8.0, 10.0, 11.9})
    EXPECT_LT(followed(shifted_m, until_s).unmodelled(), 0.3) << until_s;
  EXPECT_GT(followed(shifted_m, 12.2).unmodelled(), 0.9);
  EXPECT_GT(followed(shifted_m, 12.6).unmodelled(), 0.5);
  EXPECT_LT(followed(shifted_m, 14.0).unmodelled(), 0.3);
}

TEST(SharedMotion, ABreathIsPredictedInFullAndAJerkIsNot) {
  const SharedMotion breathing = followed(breath_m, 12.0);
  EXPECT_GT(breathing.speed_share().back(), 0.9);
  // From 8 s on, jerks of 6 mm in 0.1 s every second, up and down in turn.
  const SharedMotion jerking = followed(
      [](double t) {
        const double into = std::min(1.0, (t - std::floor(t)) / 0.1);
        const double risen = into * into * (3.0 - 2.0 * into);
        const double jerk_m = 0.006 * (static_cast<int>(std::floor(t)) % 2 == 0 ? risen : 1.0 - risen);
        return breath_m(t) + (t < 8.0 ? 0.0 : jerk_m);
      },
      18.0);
  EXPECT_LT(jerking.speed_share().back(), 0.5);
  EXPECT_LT(jerking.speed_share().back(), jerking.speed_share().front());
}

/// The prior of the regression is 2 mm: of a motion that has gone so far since a prediction, half is believed.
TEST(SharedMotion, TheSpeedOfASuddenMotionIsUsedOnlyAfterEarlierPredictionsOfItWereRight) {
  const auto rising_m = [](double t) {  // out of a held breath
    return breath_m(std::min(t, 10.5)) + 0.05 * std::clamp(t - 12.0, 0.0, 0.6);
  };
  EXPECT_LT(followed(rising_m, 12.11).speed_share().back(), 0.2) << "no prediction of the motion is 0.215 s old";
  EXPECT_GT(followed(rising_m, 12.55).speed_share().back(), 0.8);
  EXPECT_LT(followed(rising_m, 12.55).acceleration_share().back(), 0.2) << "it may end at any time";
}

}  // namespace
}  // namespace telepalp::surface
