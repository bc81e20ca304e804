#include "haptic_station/mechanism/held_linkage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "haptic_station/mechanism/crank_range.h"
#include "tests/haptic_station/mechanism/dual.h"
#include "tests/haptic_station/mechanism/seeded.h"
#include "tests/haptic_station/periods.h"
#include "tests/support/no_heap_scope.h"

namespace telepalp::mechanism {
namespace {

constexpr double kPi = std::numbers::pi;

/// The three linkages of S4's Table 1, on a link 4 that lets each of them close.
FourBar of_the_paper(int which) {
  constexpr double kRows[3][4] = {{0.08, 0.15, 0.12, -0.31}, {0.1, 0.1, 0.1, -0.17}, {0.12, 0.15, 0.08, 0.31}};
  const auto& row = kRows[which];
  FourBar bar;
  bar.l1_m = row[0];
  bar.l2_m = row[1];
  bar.l3_m = row[2];
  bar.l4_m = 0.875 * row[1];
  bar.needle_rad = row[3];
  return bar;
}

/// The place of a hand that holds the handle's end while link 3 has the angle `link3_rad`, `off_plane_m` beside the
/// plane of the linkage.
Point<HapticBase> hand_at(const FourBar& bar, double link3_rad, double off_plane_m = 0.0) {
  const Lever lever = lever_of(bar);
  const double angle = link3_rad + lever.from_link3_rad;
  return {{bar.l4_m + lever.length_m * std::cos(angle), lever.length_m * std::sin(angle), off_plane_m}};
}

FourBar any_bar(Seeded& any) {
  return {any(0.05, 0.2), any(0.05, 0.2), any(0.05, 0.2), any(0.05, 0.2), any(-3.0, 3.0),
          any(0.02, 0.2), any(-3.0, 3.0), any(0.0, 0.1),  any(0.05, 0.2)};
}

TEST(HeldLinkage, ForceOnTheHandDoesTheWorkOfTheNeedlesForceByAutomaticDifferentiation) {
  Seeded any(20261127);
  int compared = 0;
  double worst = 0.0;
  for (int i = 0; i < 30000; ++i) {
    const FourBar bar = any_bar(any);
    const double link3_rad = any(-3.1, 3.1);
    const Branch branch = any(0.0, 1.0) < 0.5 ? Branch::Open : Branch::Crossed;
    if (!checked_at(bar, link3_rad)) continue;
    const HeldLinkage held(bar, {}, link3_rad, branch);
    if (std::abs(held.sine_of_links()) < 0.1 || held.tip_travel() > 4.9) continue;
    const auto dual = four_bar_pose(bar, Dual(link3_rad, 1.0), branch == Branch::Open ? 1.0 : -1.0);
    const Force<HapticBase> needle{{any(-3.0, 3.0), any(-3.0, 3.0), any(-1.0, 1.0)}};
    const Eigen::Vector3d hand = held.hand_force(needle).N;
    const double at_tip = needle.N.x() * dual.tip.x.slope + needle.N.y() * dual.tip.y.slope;
    const double at_hand = hand.x() * dual.c.x.slope + hand.y() * dual.c.y.slope;
    const double scale = needle.N.head<2>().norm() * std::hypot(dual.tip.x.slope, dual.tip.y.slope);
    worst = std::max(worst, std::abs(at_tip - at_hand) / scale);
    EXPECT_EQ(hand.z(), 0.0) << "the bearings take what is normal to the plane";
    ++compared;
  }
  EXPECT_GT(compared, 5000);
  EXPECT_LT(worst, 1e-9) << "seed 20261127";
}

TEST(HeldLinkage, LinksKeepTheirLengthsWhereverTheHandGoes) {
  Seeded any(20261127);
  for (int which = 0; which < 3; ++which) {
    const FourBar bar = of_the_paper(which);
    HeldLinkage held(bar, {}, 0.5 * kPi, Branch::Open);
    for (int i = 0; i < 4000; ++i) {
      held.step({{any(-0.5, 0.5), any(-0.5, 0.5), any(-0.1, 0.1)}}, kTick_s);
      const FourBarPose<double>& pose = held.pose();
      ASSERT_NEAR(std::hypot(pose.p.x, pose.p.y), bar.l1_m, 1e-12);
      ASSERT_NEAR(std::hypot(pose.p.x - pose.b.x, pose.p.y - pose.b.y), bar.l2_m, 1e-12);
      ASSERT_NEAR(std::hypot(pose.b.x - bar.l4_m, pose.b.y), bar.l3_m, 1e-12);
    }
  }
}

TEST(HeldLinkage, Link3TurnsByTheAngleGotAndTheGraspLiesOnTheWayToTheHand) {
  const FourBar bar = of_the_paper(0);
  HeldLinkage held(bar, {}, 1.5, Branch::Open);
  Point<HapticBase> hand = hand_at(bar, 1.52, 0.03);
  const Eigen::Vector3d o(bar.l4_m, 0.0, 0.0);
  hand.m.head<2>() = o.head<2>() + 1.1 * (hand.m.head<2>() - o.head<2>());
  held.step(hand, 1.0);
  EXPECT_NEAR(held.link3_rad(), 1.52, 1e-12);
  EXPECT_NEAR((held.grasp().m - o).norm(), lever_of(bar).length_m, 1e-12);
  const Eigen::Vector3d expected = 500.0 * (held.grasp().m - hand.m);  // eq. (8), with the pull back into the plane
  EXPECT_LT((held.constraint_force().N - expected).norm(), 1e-9);
  EXPECT_LT(held.constraint_force().N.z(), -14.9);
}

TEST(HeldLinkage, NeedleGoesIntoThePatientAsTheHandTurnsLink3) {
  for (int which = 0; which < 3; ++which) {
    const FourBar bar = of_the_paper(which);
    HeldLinkage held(bar, {}, 0.5 * kPi, Branch::Open);
    const double before_m = held.tip().m.x();
    held.step(hand_at(bar, 0.5 * kPi + 0.02), kTick_s);
    EXPECT_LT(held.tip().m.x(), before_m - 0.001) << "linkage " << which + 1;
    EXPECT_LT(held.needle_axis().v.x(), -0.9) << "linkage " << which + 1;
    EXPECT_NEAR(held.tip_velocity().v.x(), (held.tip().m.x() - before_m) / kTick_s, 1e-9);
  }
}

/// Turns link 3 beyond both of its dead points and back.
struct ThroughDeadPoints {
  double largest_N = 0.0;
  double largest_step_N = 0.0;
  bool finite = true;
  bool branch_kept = true;
};
ThroughDeadPoints through_dead_points(Branch branch, int ticks) {
  const FourBar bar = of_the_paper(0);
  HeldLinkage held(bar, {}, 1.5, branch);
  const Force<HapticBase> needle{{1.0, 0.0, 0.0}};
  Eigen::Vector3d last = held.hand_force(needle).N;
  ThroughDeadPoints out;
  for (int i = 1; i <= ticks; ++i) {
    held.step(hand_at(bar, 1.5 - 1.5 * std::sin(2.0 * kPi * i / ticks)), kTick_s);
    const Eigen::Vector3d now = held.hand_force(needle).N;
    out.finite &= now.allFinite() && held.tip().m.allFinite();
    out.branch_kept &= held.branch() == branch;
    out.largest_N = std::max(out.largest_N, now.norm());
    out.largest_step_N = std::max(out.largest_step_N, (now - last).norm());
    last = now;
  }
  return out;
}

TEST(HeldLinkage, AtADeadPointTheForceStaysAtItsBoundWithoutAStepAndTheBranchIsKept) {
  for (const Branch branch : {Branch::Open, Branch::Crossed}) {
    const ThroughDeadPoints slow = through_dead_points(branch, 80000);
    const ThroughDeadPoints slower = through_dead_points(branch, 160000);
    EXPECT_TRUE(slow.finite && slow.branch_kept);
    EXPECT_LE(slow.largest_N, 5.0 + 1e-9) << "1 N at the needle, with the largest gain";
    EXPECT_GT(slow.largest_N, 2.0) << "the way leads through the dead points";
    EXPECT_LT(slower.largest_step_N, 0.6 * slow.largest_step_N) << "half the way, half the step: no jump";
  }
}

TEST(HeldLinkage, ParametersThatChangeInUseMoveNoForceByAStep) {
  const FourBar before = of_the_paper(0);
  for (const double hold_rad : {1.5, crank_range(before, 1.5).from_rad}) {  // the second one is a dead point
    HeldLinkage held(before, {}, hold_rad, Branch::Open);
    FourBar after = of_the_paper(2);
    after.handle_rad = 2.0;
    after.handle_at_m = 0.08;
    const Point<HapticBase> hand = held.grasp();
    held.step(hand, kTick_s);
    held.set(after);
    const Force<HapticBase> needle{{1.0, 0.2, 0.0}};
    Eigen::Vector3d constraint = held.constraint_force().N;
    Eigen::Vector3d through = held.hand_force(needle).N;
    double largest_N = 0.0;
    double largest_through_N = 0.0;
    for (int i = 0; i < 30000; ++i) {
      held.step(hand, kTick_s);
      largest_N = std::max(largest_N, (held.constraint_force().N - constraint).norm());
      largest_through_N = std::max(largest_through_N, (held.hand_force(needle).N - through).norm());
      constraint = held.constraint_force().N;
      through = held.hand_force(needle).N;
    }
    EXPECT_EQ(held.bar().l1_m, after.l1_m) << "the change is complete";
    EXPECT_LT(largest_N, 0.05);
    EXPECT_LT(largest_through_N, 0.05);
  }
}

TEST(HeldLinkage, AChangePointLinkageGoesOnThroughTheLineOnWhichAllJointsLie) {
  FourBar parallelogram;
  parallelogram.l1_m = parallelogram.l3_m = 0.1;
  parallelogram.l2_m = parallelogram.l4_m = 0.15;
  FourBar rhombus;
  rhombus.l1_m = rhombus.l2_m = rhombus.l3_m = rhombus.l4_m = 0.1;
  for (const FourBar& bar : {parallelogram, rhombus}) {
    HeldLinkage held(bar, {}, 1.5, Branch::Open);
    for (int i = 1; i <= 8000; ++i) {
      held.step(hand_at(bar, 1.5 + 4.0 * kPi * i / 8000), kTick_s);
      const double link1_rad = std::atan2(held.pose().p.y, held.pose().p.x);
      ASSERT_NEAR(std::remainder(link1_rad - held.link3_rad(), 2.0 * kPi), 0.0, 1e-6) << "links 1 and 3 stay parallel";
    }
  }
}

TEST(HeldLinkage, AHandAcrossThePivotTurnsTheLinkageAtABoundedSpeed) {
  const FourBar bar = of_the_paper(0);
  HeldLinkage held(bar, {}, 1.5, Branch::Open);
  Point<HapticBase> hand = hand_at(bar, 1.5);
  double last_rad = held.link3_rad();
  for (int i = 0; i < 400; ++i) {
    hand.m = Eigen::Vector3d(bar.l4_m, 0.0, 0.0) +
             (1.0 - i / 200.0) * (hand_at(bar, 1.5).m - Eigen::Vector3d(bar.l4_m, 0.0, 0.0));
    held.step(hand, kTick_s);
    ASSERT_LE(std::abs(held.link3_rad() - last_rad), 50.0 * kTick_s + 1e-12);
    last_rad = held.link3_rad();
  }
}

TEST(HeldLinkage, TicksTouchNoHeap) {
  const FourBar bar = of_the_paper(1);
  HeldLinkage held(bar, {}, 1.5, Branch::Open);
  held.set(of_the_paper(2));
  const test::NoHeapScope guard;
  for (int i = 0; i < 2000; ++i) {
    held.step(hand_at(bar, 1.5 + 0.001 * (i % 300)), kTick_s);
    ASSERT_TRUE((held.hand_force({{1.0, 0.0, 0.0}}).N + held.constraint_force().N).allFinite());
  }
}

}  // namespace
}  // namespace telepalp::mechanism
