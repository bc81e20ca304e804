#include "haptic_station/mechanism/four_bar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptic_station/mechanism/crank_range.h"

namespace telepalp::mechanism {
namespace {

FourBar links(double l1_mm, double l2_mm, double l3_mm, double l4_mm) {
  FourBar bar;
  bar.l1_m = 1e-3 * l1_mm;
  bar.l2_m = 1e-3 * l2_mm;
  bar.l3_m = 1e-3 * l3_mm;
  bar.l4_m = 1e-3 * l4_mm;
  return bar;
}

TEST(FourBar, GrashofClassFollowsTheShortestLinkForThePapersLinkages) {
  EXPECT_EQ(grashof_class(links(80, 150, 120, 40)), GrashofClass::DoubleCrank);
  EXPECT_EQ(grashof_class(links(80, 150, 120, 50)), GrashofClass::ChangePoint);
  EXPECT_EQ(grashof_class(links(80, 150, 120, 80.1)), GrashofClass::TripleRocker);
  EXPECT_EQ(grashof_class(links(80, 150, 120, 150)), GrashofClass::CrankOfLink1);
  EXPECT_EQ(grashof_class(links(120, 150, 80, 150)), GrashofClass::CrankOfLink3);
  EXPECT_EQ(grashof_class(links(120, 80, 130, 150)), GrashofClass::DoubleRocker);
  EXPECT_EQ(grashof_class(links(80, 150, 120, 200)), GrashofClass::TripleRocker);
  EXPECT_EQ(grashof_class(links(100, 100, 100, 100)), GrashofClass::ChangePoint);
  EXPECT_EQ(grashof_class(links(100, 100, 100, 101)), GrashofClass::TripleRocker);
}

TEST(FourBar, LinksThatCannotCloseAreRefusedWithTheirLengths) {
  const Result<FourBar> refused = checked(links(80, 150, 120, 350));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(
      refused.error().what,
      "links l1 = 80, l2 = 150, l3 = 120 and l4 = 350 mm cannot close: the longest is 350 mm, and the other three "
      "together are 350 mm");
  EXPECT_EQ(refused.error().fix, "make the longest link shorter than the sum of the other three");
  EXPECT_TRUE(checked(links(80, 150, 120, 349.9)).ok());
}

TEST(FourBar, AnAngleAtWhichTheLoopIsOpenIsRefusedWithTheRangeOfLink3) {
  const Result<FourBar> refused = checked_at(links(80, 150, 120, 150), 0.5);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("cannot close while link 3 has the angle 0.5 rad: link 3 turns from 1.110"),
            std::string::npos)
      << refused.error().what;
  EXPECT_TRUE(checked_at(links(80, 150, 120, 150), 1.2).ok());
}

TEST(FourBar, NumbersThatAreNotFiniteAreRefusedByName) {
  FourBar bar;
  bar.handle_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(checked(bar).error().what, "phi is not a finite number");
  bar = {};
  bar.l4_m = std::numeric_limits<double>::infinity();
  EXPECT_EQ(checked(bar).error().what, "l4 is not a finite number");
  EXPECT_FALSE(checked_at({}, std::numeric_limits<double>::quiet_NaN()).ok());
}

TEST(FourBar, ALinkWithoutLengthAndAHandleThatEndsAtThePivotAreRefused) {
  EXPECT_EQ(checked(links(80, 0, 120, 130)).error().what,
            "l2 is 0 mm, in links l1 = 80, l2 = 0, l3 = 120 and l4 = 130 mm");
  FourBar bar;
  bar.handle_at_m = 0.1;
  bar.handle_m = 0.1;
  bar.handle_rad = 3.14159265358979;
  EXPECT_NE(checked(bar).error().what.find("a hand cannot turn link 3"), std::string::npos);
}

TEST(CrankRange, EndsWhereLinks1And2LieOnOneLine) {
  const FourBar bar = links(80, 150, 120, 150);
  const CrankRange range = crank_range(bar, 1.5);
  for (const double end_rad : {range.from_rad, range.to_rad}) {
    const double ab_m = std::hypot(0.15 + 0.12 * std::cos(end_rad), 0.12 * std::sin(end_rad));
    EXPECT_LT(std::min(std::abs(ab_m - 0.23), std::abs(ab_m - 0.07)), 1e-12);
  }
  const CrankRange below = crank_range(bar, -1.5);
  EXPECT_DOUBLE_EQ(below.to_rad, -range.from_rad);
  const CrankRange turned = crank_range(bar, 1.5 + 4.0 * 3.14159265358979324);
  EXPECT_NEAR(turned.from_rad - range.from_rad, 4.0 * 3.14159265358979324, 1e-12);
  EXPECT_TRUE(crank_range(links(120, 150, 80, 150), 0.0).whole_turn);
}

}  // namespace
}  // namespace telepalp::mechanism
