#include <gtest/gtest.h>

#include "tests/tools/study/ideal_observer.h"

namespace telepalp::study {
namespace {

TEST(Staircase, FindsTheThresholdOfItsTargetWhichTheRatioOfItsStepsSets) {
  const FoundThresholds right = staircase_thresholds(0.3, {}, kStaircaseTarget, 200);
  EXPECT_NEAR(right.mean, 1.0, 0.05);
  const FoundThresholds equal = staircase_thresholds(0.3, {.down_by_up = 1.0}, kStaircaseTarget, 200);
  EXPECT_LT(equal.mean, 0.93);
}

TEST(Staircase, GoesUpAtOnceAndDownAfterThreeRightAnswers) {
  Staircase staircase;
  const double first = staircase.difference();
  staircase.answer(true);
  staircase.answer(true);
  EXPECT_EQ(staircase.difference(), first);
  staircase.answer(true);
  EXPECT_LT(staircase.difference(), first);
  const double lower = staircase.difference();
  staircase.answer(false);
  EXPECT_GT(staircase.difference(), lower);
  EXPECT_FALSE(staircase.threshold());
}

TEST(Quest, FindsTheThresholdOfAnObserverItDoesNotKnow) {
  for (const double weber_fraction : {0.15, 0.3, 0.42})
    EXPECT_NEAR(quest_thresholds(weber_fraction, 100, 100).mean, 1.0, 0.07) << weber_fraction;
}

TEST(Staircase, StaysBelowItsLargestDifferenceWhenEachAnswerIsWrong) {
  Staircase staircase({.most = 2.0});
  for (int i = 0; i < 30; ++i) staircase.answer(false);
  EXPECT_DOUBLE_EQ(staircase.difference(), 2.0);
}

}  // namespace
}  // namespace telepalp::study
