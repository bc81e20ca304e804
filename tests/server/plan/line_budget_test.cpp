#include "server/plan/line_budget.h"

#include <gtest/gtest.h>

namespace telepalp::plan {
namespace {

using namespace std::chrono_literals;

constexpr double kFull_B_per_s = 500'000.0;

/// A line whose reports are made by hand: five steps a second, each with 12 images.
struct Reports {
  LineBudget budget;
  LineReport report;
  SessionTime now{1s};

  void step(double sent_B_per_s, std::uint64_t dropped = 0, Nanoseconds queue = 0ns) {
    now += 200ms;
    report.offered += 12;
    report.dropped += dropped;
    report.sent_B += static_cast<std::uint64_t>(0.2 * sent_B_per_s);
    report.queue = queue;
    budget.step(report, kFull_B_per_s, now);
  }
};

TEST(LineBudget, ThereIsNoneWhileALineIsNotFull) {
  Reports line;
  for (int i = 0; i < 100; ++i) line.step(kFull_B_per_s);
  EXPECT_FALSE(line.budget.B_per_s());
}

TEST(LineBudget, OneDroppedImageSaysNothing) {
  Reports line;
  for (int i = 0; i < 10; ++i) line.step(kFull_B_per_s);
  line.step(kFull_B_per_s, 1);
  EXPECT_FALSE(line.budget.B_per_s());
}

TEST(LineBudget, ItIsWhatLeftForAFullLine) {
  for (const bool by_queue : {false, true}) {
    Reports line;
    for (int i = 0; i < 10; ++i) line.step(kFull_B_per_s);
    for (int i = 0; i < 3 && !line.budget.B_per_s(); ++i) line.step(200'000.0, by_queue ? 0 : 5, by_queue ? 60ms : 0ns);
    ASSERT_TRUE(line.budget.B_per_s());
    EXPECT_LE(*line.budget.B_per_s(), 0.95 * 200'000.0);
    EXPECT_GE(*line.budget.B_per_s(), 0.85 * 200'000.0);
  }
}

TEST(LineBudget, WhatIsTriedIsNotCountedOnBeforeItHasFitted) {
  Reports line;
  for (int i = 0; i < 5; ++i) line.step(200'000.0, 4);
  const double fits = line.budget.B_per_s().value_or(0.0);
  for (int i = 0; i < 30 && line.budget.tried_B_per_s() <= fits; ++i) line.step(fits);
  EXPECT_GT(line.budget.tried_B_per_s(), 1.05 * fits);
  EXPECT_EQ(line.budget.B_per_s().value_or(0.0), fits);
  line.step(line.budget.tried_B_per_s(), 4);  // it does not fit
  EXPECT_LE(line.budget.B_per_s().value_or(0.0), fits);
  EXPECT_GE(line.budget.B_per_s().value_or(0.0), 0.9 * fits) << "a try that fails costs little";
}

TEST(LineBudget, ItEndsWithinFiveSecondsAfterALineHasBecomeWide) {
  Reports line;
  for (int i = 0; i < 10; ++i) line.step(50'000.0, 4);
  const SessionTime wide_since = line.now;
  while (line.budget.B_per_s() && line.now - wide_since < 20s) line.step(line.budget.tried_B_per_s());
  EXPECT_LE(to_seconds(line.now - wide_since), 5.0);
}

TEST(LineBudget, ItStaysBelowTheShareThatOtherFlowsLeave) {
  Reports line;
  line.report.share_B_per_s = 150'000.0;
  for (int i = 0; i < 50; ++i) {
    line.step(std::min(kFull_B_per_s, line.budget.B_per_s().value_or(kFull_B_per_s)));
    if (i > 2) {
      EXPECT_LE(line.budget.tried_B_per_s(), 150'000.0);
    }
  }
}

TEST(LineBudget, CountsThatGoBackBelongToANewConnection) {
  Reports line;
  for (int i = 0; i < 5; ++i) line.step(kFull_B_per_s);
  line.report = {};
  for (int i = 0; i < 5; ++i) line.step(kFull_B_per_s);
  EXPECT_FALSE(line.budget.B_per_s());
}

}  // namespace
}  // namespace telepalp::plan
