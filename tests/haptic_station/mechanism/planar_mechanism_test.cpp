#include "haptic_station/mechanism/planar_mechanism.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "haptic_station/mechanism/held_linkage.h"
#include "haptic_station/mechanism/planar_designs.h"
#include "tests/haptic_station/mechanism/dual.h"
#include "tests/haptic_station/mechanism/seeded.h"
#include "tests/support/no_heap_scope.h"

namespace telepalp::mechanism {
namespace {

using Eigen::Vector2d;
using D = InPlane<Dual>;

HeldMechanism held(const PlanarDesign& design) { return *assembled(design.mechanism, design.near); }

/// Where circles about two points meet: the text-book way to close a loop, in dual numbers.
D meeting(const D& one, double one_m, const D& other, double other_m, double side) {
  const D between = other - one;
  const Dual squared = dot(between, between);
  const Dual along = (Dual(one_m * one_m - other_m * other_m) + squared) / (Dual(2.0) * squared);
  const Dual across = Dual(side) * sqrt(Dual(one_m * one_m) / squared - along * along);
  return one + along * between + across * left_of(between);
}

/// Virtual work, for one small motion of the mechanism: |work of `needle_N` at the tip - work of the hand's force at
/// the grasp|, as a share of the most work that a force as large as `needle_N` can do at the tip.
double work_difference(const HeldMechanism& mechanism, const D& tip, const D& grasp, const Vector2d& needle_N) {
  const Vector2d hand_N = mechanism.hand_force_N(needle_N);
  const double at_tip = needle_N.x() * tip.x.slope + needle_N.y() * tip.y.slope;
  const double at_hand = hand_N.x() * grasp.x.slope + hand_N.y() * grasp.y.slope;
  return std::abs(at_tip - at_hand) / (needle_N.norm() * std::hypot(tip.x.slope, tip.y.slope));
}

TEST(PlanarMechanism, FollowsTheHandAsTheFourBarsClosedFormDoes) {
  Seeded any(7);
  FourBar bar;
  const HoldSettings unbounded{.fastest_rad_per_s = 1e9};
  HeldMechanism general = held(four_bar_design(bar, 1.5));
  HeldLinkage closed(bar, {}, 1.5, Branch::Open, unbounded);
  const Vector2d middle = general.grasp_m();
  for (int i = 0; i < 3000; ++i) {
    const Vector2d hand = middle + 0.03 * Vector2d(std::sin(0.005 * i), std::sin(0.008 * i));
    general.step(hand);
    closed.step({{hand.x(), hand.y(), 0.0}}, 1.0);
    ASSERT_LT((general.tip_m() - closed.tip().m.head<2>()).norm(), 1e-8);
    ASSERT_LT((general.hand_force_N({1.0, 0.3}) - closed.hand_force({{1.0, 0.3, 0.0}}).N.head<2>()).norm(), 1e-6);
    ASSERT_LT(general.open_m(), 1e-12);
  }
}

TEST(PlanarMechanism, SliderCrankDoesTheWorkOfItsNeedleByAutomaticDifferentiation) {
  Seeded any(7);
  const SliderCrank crank;
  for (int i = 0; i < 300; ++i) {
    const double rad = any(0.3, 2.8);
    const HeldMechanism mechanism = held(slider_crank_design(crank, rad));
    const Dual turn(rad, 1.0);
    const D link{cos(turn), sin(turn)};
    const Dual y = Dual(crank.crank_m) * link.y;
    const D tip{Dual(crank.crank_m) * link.x - sqrt(Dual(crank.rod_m * crank.rod_m) - y * y) - Dual(crank.needle_m),
                Dual(0.0)};
    ASSERT_NEAR(mechanism.tip_m().x(), tip.x.value, 1e-12);
    ASSERT_LT(work_difference(mechanism, tip, Dual(crank.handle_m) * link, {any(-3.0, 3.0), any(-3.0, 3.0)}), 1e-9);
  }
}

TEST(PlanarMechanism, FiveBarWithTwoDegreesOfFreedomDoesTheWorkOfItsNeedleForBoth) {
  Seeded any(7);
  const FiveBar bar;
  for (int i = 0; i < 300; ++i) {
    const Vector2d joint(any(0.0, 0.1), any(0.1, 0.17));
    const HeldMechanism mechanism = held(five_bar_design(bar, joint));
    ASSERT_EQ(mechanism.freedoms(), 2);
    const Vector2d needle_N(any(-3.0, 3.0), any(-3.0, 3.0));
    for (const Vector2d& way : {Vector2d(1.0, 0.0), Vector2d(0.0, 1.0)}) {
      const D grasp{Dual(joint.x(), way.x()), Dual(joint.y(), way.y())};
      const D left = meeting({Dual(0.0), Dual(0.0)}, bar.left_m, grasp, bar.left_far_m, 1.0);
      const D tip = grasp + Dual(bar.needle_m / bar.left_far_m) * (grasp - left);
      ASSERT_LT((mechanism.tip_m() - Vector2d(tip.x.value, tip.y.value)).norm(), 1e-12);
      ASSERT_LT(work_difference(mechanism, tip, grasp, needle_N), 1e-9);
    }
  }
}

TEST(PlanarMechanism, SixBarDoesTheWorkOfItsNeedleByAutomaticDifferentiation) {
  Seeded any(7);
  const SixBar bar;
  for (int i = 0; i < 300; ++i) {
    const double rad = any(1.3, 2.0);
    const Result<HeldMechanism> mechanism =
        assembled(six_bar_design(bar, rad).mechanism, six_bar_design(bar, rad).near);
    ASSERT_TRUE(mechanism.ok()) << to_string(mechanism.error());
    const auto four = four_bar_pose(bar.bar, Dual(rad, 1.0), 1.0);
    const D arm = Dual(1.0 + bar.arm_m / bar.bar.l1_m) * four.p;
    const D end = meeting({Dual(bar.pivot_m), Dual(0.0)}, bar.rocker_m, arm, bar.rod_m, 1.0);
    const D tip = end + Dual(bar.needle_m / bar.rod_m) * (end - arm);
    ASSERT_LT((mechanism->tip_m() - Vector2d(tip.x.value, tip.y.value)).norm(), 1e-12);
    ASSERT_LT(work_difference(*mechanism, tip, four.c, {any(-3.0, 3.0), any(-3.0, 3.0)}), 1e-9);
  }
}

TEST(PlanarMechanism, AtADeadPointItStaysOnItsBranchWithAFiniteForce) {
  SliderCrank crank;
  crank.crank_m = 0.15;
  crank.rod_m = 0.1;  // shorter than the crank: the slider's line can be reached only while the crank is low
  HeldMechanism mechanism = held(slider_crank_design(crank, 0.3));
  const Vector2d start = mechanism.tip_m();
  for (int i = 0; i < 4000; ++i) {
    const double rad = 0.3 + 0.9 * std::sin(3.14159265358979 * i / 4000);
    mechanism.step({crank.handle_m * std::cos(rad), crank.handle_m * std::sin(rad)});
    ASSERT_LT(mechanism.open_m(), 1e-7);
    ASSERT_LE(mechanism.hand_force_N({1.0, 0.0}).norm(), 5.0 + 1e-9);
  }
  mechanism.step({crank.handle_m * std::cos(0.3), crank.handle_m * std::sin(0.3)});
  EXPECT_LT((mechanism.tip_m() - start).norm(), 1e-6) << "the way back is the way there";
}

TEST(PlanarMechanism, JointsThatCannotCloseAreRefusedWithTheGap) {
  SliderCrank crank;
  crank.rod_m = 0.02;
  const PlanarDesign design = slider_crank_design(crank, 1.5);
  const Result<HeldMechanism> refused = assembled(design.mechanism, design.near);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("the widest gap is"), std::string::npos) << refused.error().what;
}

TEST(PlanarMechanism, AMechanismThatMovesByNothingOrByTooMuchIsRefused) {
  PlanarDesign design = four_bar_design({}, 1.5);
  design.mechanism.pins.pop_back();
  const Result<HeldMechanism> loose = assembled(design.mechanism, design.near);
  ASSERT_FALSE(loose.ok());
  EXPECT_EQ(loose.error().what, "the mechanism has 3 degrees of freedom");
  design.near[0] = std::nan("");
  EXPECT_FALSE(assembled(design.mechanism, design.near).ok());
  design.mechanism.bodies = 9;
  EXPECT_NE(assembled(design.mechanism, design.near).error().fix.find("1 to 6 bodies"), std::string::npos);
}

TEST(PlanarMechanism, TicksTouchNoHeap) {
  HeldMechanism mechanism = held(six_bar_design({}, 1.5));
  const Vector2d middle = mechanism.grasp_m();
  const test::NoHeapScope guard;
  for (int i = 0; i < 300; ++i) {
    mechanism.step(middle + 0.01 * Vector2d(std::sin(0.01 * i), std::cos(0.01 * i)));
    ASSERT_TRUE(mechanism.hand_force_N({1.0, 0.0}).allFinite());
  }
}

}  // namespace
}  // namespace telepalp::mechanism
