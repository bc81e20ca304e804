#include "haptic_station/mechanism/felt_linkage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/haptic_station/mechanism/seeded.h"
#include "tests/support/no_heap_scope.h"

namespace telepalp::mechanism {
namespace {

using Eigen::Vector3d;

constexpr double kTick = 0.0005;
constexpr FeltSettings kSettings;
const double kSurface_m = kSettings.link_radius_m + kSettings.hand_radius_m;

FeltLinkage linkage(const FourBar& bar = {}) { return *FeltLinkage::make(HeldLinkage(bar, {}, 1.5, Branch::Open)); }

Vector3d in_space(const InPlane<double>& at, double z = 0.0) { return {at.x, at.y, z}; }

/// A point on the axis of link 1, between A and P.
Vector3d on_link1(const FeltLinkage& felt, double share) { return share * in_space(felt.pose().p); }

/// Moves the hand evenly to `to` in `ticks`, and returns the largest step of the force.
double go(FeltLinkage& felt, Vector3d& hand, const Vector3d& to, bool pressed, int ticks) {
  const Vector3d each = (to - hand) / ticks;
  double most_N = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const Vector3d before = felt.contact_force().N;
    hand += each;
    felt.step({hand}, pressed, kTick);
    most_N = std::max(most_N, (felt.contact_force().N - before).norm() - kSettings.stiffness_N_per_m * each.norm());
  }
  return most_N;
}

TEST(FeltLinkage, ARodPushesAlongItsNormalByItsDepth) {
  FeltLinkage felt = linkage();
  Vector3d hand = on_link1(felt, 0.5) + Vector3d(0, 0, 0.03);
  (void)go(felt, hand, on_link1(felt, 0.5) + Vector3d(0, 0, kSurface_m + 0.001), false, 200);
  EXPECT_EQ(felt.touched(), std::nullopt);
  EXPECT_EQ(felt.contact_force().N, Vector3d(Vector3d::Zero()));
  (void)go(felt, hand, on_link1(felt, 0.5) + Vector3d(0, 0, kSurface_m - 0.002), false, 200);
  EXPECT_EQ(felt.touched(), LinkPart::Link1);
  EXPECT_NEAR(felt.contact_force().N.z(), 0.002 * kSettings.stiffness_N_per_m, 1e-3);
  EXPECT_LT(felt.contact_force().N.head<2>().norm(), 1e-3);
}

TEST(FeltLinkage, EachPartIsFeltUnderItsName) {
  FeltLinkage felt = linkage();
  const FourBarPose<double> at = felt.pose();
  const auto middle = [](const InPlane<double>& a, const InPlane<double>& b) -> Vector3d {
    return 0.5 * (in_space(a) + in_space(b));
  };
  const InPlane<double> o{felt.bar().l4_m, 0.0};
  const std::pair<LinkPart, Vector3d> parts[] = {{LinkPart::Link1, middle({}, at.p)},
                                                 {LinkPart::Link2, middle(at.p, at.b)},
                                                 {LinkPart::Link3, 0.9 * in_space(at.b) + 0.1 * in_space(o)},
                                                 {LinkPart::Handle, in_space(at.c)},
                                                 {LinkPart::Needle, in_space(at.tip)},
                                                 {LinkPart::Base, middle({}, o)}};
  for (const auto& [part, place] : parts) {
    FeltLinkage one = linkage();
    Vector3d hand = place + Vector3d(0, 0, 0.03);
    (void)go(one, hand, place + Vector3d(0, 0, 0.003), false, 200);
    EXPECT_EQ(one.touched(), part) << name(part);
  }
}

TEST(FeltLinkage, AFastHandDoesNotPassThroughARod) {
  FeltLinkage felt = linkage();
  felt.step({on_link1(felt, 0.5) + Vector3d(0, 0, 0.02)}, false, kTick);
  felt.step({on_link1(felt, 0.5) + Vector3d(0, 0, -0.005)}, false, kTick);  // 50 m/s
  EXPECT_EQ(felt.touched(), LinkPart::Link1);
  EXPECT_GT(felt.contact_force().N.z(), 1.0);
}

/// Force along the way of a point that is held on link 1, which turns about the origin: what is left across the way
/// keeps the hand on its circle.
double along_the_way_N(const FeltLinkage& felt) {
  const Vector3d from_a = felt.proxy().m.normalized();
  const Vector3d N = felt.contact_force().N;
  return (N - N.dot(from_a) * from_a).norm();
}

TEST(FeltLinkage, AButtonInATouchTakesHoldThereWithoutAStepOfForceAndMovesTheLinkage) {
  for (const double share : {0.4, 0.9}) {
    FeltLinkage felt = linkage();
    const Vector3d place = on_link1(felt, share);
    const Vector3d side = Vector3d(-place.y(), place.x(), 0).normalized();
    Vector3d hand = place + 0.03 * side;
    (void)go(felt, hand, place + (kSurface_m - 0.004) * side, false, 200);
    ASSERT_NEAR(felt.contact_force().N.norm(), 2.0, 1e-3);
    const Vector3d tip = felt.tip().m;
    EXPECT_LT(go(felt, hand, hand, true, 1), 0.05);
    EXPECT_EQ(felt.held(), LinkPart::Link1);
    EXPECT_LT(go(felt, hand, hand, true, 1000), 0.05);
    EXPECT_LT(along_the_way_N(felt), 0.01) << "the linkage has come to the hand";
    EXPECT_LT(go(felt, hand, hand - 0.01 * side, true, 400), 0.05);
    EXPECT_GT((felt.tip().m - tip).norm(), 0.003);
    EXPECT_LT(along_the_way_N(felt), 0.05);
  }
}

TEST(FeltLinkage, AButtonPressedBeforeTheTouchTakesNoHold) {
  FeltLinkage felt = linkage();
  Vector3d hand = on_link1(felt, 0.5) + Vector3d(0, 0, 0.03);
  (void)go(felt, hand, on_link1(felt, 0.5) + Vector3d(0, 0, 0.005), true, 200);
  EXPECT_EQ(felt.held(), std::nullopt);
  EXPECT_EQ(felt.touched(), LinkPart::Link1);
  felt.step({hand}, false, kTick);
  felt.step({hand}, true, kTick);
  EXPECT_EQ(felt.held(), LinkPart::Link1);
}

TEST(FeltLinkage, LettingGoMakesNoStepOfForceAndTheLinkageStays) {
  FeltLinkage felt = linkage();
  felt.hold(LinkPart::Handle, {in_space(felt.pose().c)});
  Vector3d hand = felt.proxy().m;
  (void)go(felt, hand, hand + Vector3d(0, 0, 0.01), true, 200);  // out of the plane: the grasp pulls back
  ASSERT_NEAR(felt.contact_force().N.z(), -5.0, 0.01);
  const Vector3d tip = felt.tip().m;
  EXPECT_LT(go(felt, hand, hand, false, 1), 0.1);
  EXPECT_LT(go(felt, hand, hand, false, 600), 0.1);
  EXPECT_LT(felt.contact_force().N.norm(), 0.01);
  EXPECT_EQ(felt.tip().m, tip);
  EXPECT_EQ(felt.held(), std::nullopt);
}

TEST(FeltLinkage, WithTheHandAtTheHandleItIsTheHeldLinkage) {
  HeldLinkage held({}, {}, 1.5, Branch::Open, {.fastest_rad_per_s = 1e9});
  FeltLinkage felt = *FeltLinkage::make(held);
  felt.hold(LinkPart::Handle, held.grasp());
  const Vector3d middle = held.grasp().m;
  const Force<HapticBase> needle{{1.0, 0.3, 0.2}};
  for (int i = 0; i < 2000; ++i) {
    const Vector3d hand = middle + 0.03 * Vector3d(std::sin(0.005 * i), std::sin(0.008 * i), std::sin(0.003 * i));
    held.step({hand}, kTick);
    felt.step({hand}, true, kTick);
    ASSERT_LT((felt.tip().m - held.tip().m).norm(), 1e-8);
    ASSERT_LT((felt.needle_axis().v - held.needle_axis().v).norm(), 1e-7);
    ASSERT_LT((felt.hand_force(needle).N - held.hand_force(needle).N).norm(), 1e-6);
    ASSERT_LT((felt.contact_force().N - held.constraint_force().N).norm(), 1e-4);
    ASSERT_NEAR(felt.sine_of_links(), held.sine_of_links(), 1e-8);
  }
}

/// A motion of the held point, and the motion of the tip that belongs to it, from two poses that are 1e-6 m apart.
TEST(FeltLinkage, TheForceOnTheHandIsTheNeedlesByVirtualWorkWhereverItIsHeld) {
  Seeded any(11);
  for (int i = 0; i < 60; ++i) {
    FeltLinkage felt = linkage();
    const auto part = static_cast<LinkPart>(i % 5);
    const FourBarPose<double> at = felt.pose();
    const Vector3d ends[][2] = {{Vector3d::Zero(), in_space(at.p)},
                                {in_space(at.b), in_space(at.p)},
                                {Vector3d(felt.bar().l4_m, 0, 0), in_space(at.b)},
                                {in_space(at.d), in_space(at.c)},
                                {in_space(at.p), in_space(at.tip)}};
    const Vector3d* const end = ends[static_cast<std::size_t>(part)];
    felt.hold(part, {end[0] + any(0.4, 0.9) * (end[1] - end[0])});
    const Force<HapticBase> needle{{any(-2, 2), any(-2, 2), 0.0}};
    const Vector3d force = felt.hand_force(needle).N;
    const Vector3d hand = felt.proxy().m;
    const Vector3d tip = felt.tip().m;
    felt.step({hand + 1e-6 * force.normalized()}, true, kTick);
    const double at_tip = needle.N.dot(felt.tip().m - tip);
    const double at_hand = force.dot(felt.proxy().m - hand);
    ASSERT_GT((felt.proxy().m - hand).norm(), 1e-8) << name(part);
    EXPECT_NEAR(at_tip, at_hand, 1e-3 * std::abs(at_hand)) << name(part);
  }
}

TEST(FeltLinkage, TheBaseIsFeltAndNotHeld) {
  FeltLinkage felt = linkage();
  const Vector3d place(0.5 * felt.bar().l4_m, 0, 0);
  Vector3d hand = place + Vector3d(0, 0, 0.03);
  (void)go(felt, hand, place + Vector3d(0, 0, 0.005), false, 200);
  EXPECT_EQ(felt.touched(), LinkPart::Base);
  felt.step({hand}, true, kTick);
  EXPECT_EQ(felt.held(), std::nullopt);
}

TEST(FeltLinkage, LengthsThatChangeInTheHandMoveNoForceByAStep) {
  for (const LinkPart part : {LinkPart::Link1, LinkPart::Link2, LinkPart::Link3, LinkPart::Handle, LinkPart::Needle}) {
    FeltLinkage felt = linkage();
    felt.hold(part, {in_space(felt.pose().p)});
    if (part == LinkPart::Handle) felt.hold(part, {in_space(felt.pose().c)});
    Vector3d hand = felt.proxy().m;
    FourBar other = felt.bar();
    other.l1_m += 0.01;
    other.l3_m -= 0.008;
    other.needle_rad += 0.2;
    other.handle_rad += 0.3;
    other.handle_m += 0.02;
    felt.set(other);
    EXPECT_LT(go(felt, hand, hand, true, 6000), 0.02) << name(part);
    EXPECT_EQ(felt.bar(), other) << name(part);
    const FourBarPose<double> at = felt.pose();
    EXPECT_NEAR((in_space(at.p) - in_space(at.b)).norm(), other.l2_m, 1e-9) << name(part);
    EXPECT_NEAR(in_space(at.p).norm(), other.l1_m, 1e-9) << name(part);
    if (part != LinkPart::Handle) continue;
    EXPECT_LT((felt.proxy().m - in_space(at.c)).norm(), 1e-9) << "the hand keeps its end";
  }
}

TEST(FeltLinkage, APartThatGrowsAgainstAHandPushesItWithoutAStep) {
  FeltLinkage felt = linkage();
  const Vector3d end = in_space(felt.pose().c);
  const Vector3d along = (end - in_space(felt.pose().d)).normalized();
  Vector3d hand = end + 0.03 * along;
  (void)go(felt, hand, end + (kSurface_m - 0.001) * along, false, 400);
  ASSERT_EQ(felt.touched(), LinkPart::Handle);
  FourBar longer = felt.bar();
  longer.handle_m += 0.004;
  felt.set(longer);
  EXPECT_LT(go(felt, hand, hand, false, 1000), 0.02);
  EXPECT_NEAR(felt.contact_force().N.norm(), 0.005 * kSettings.stiffness_N_per_m, 1e-3);
}

TEST(FeltLinkage, AHandThatIsNotANumberMovesAndFeelsNothing) {
  FeltLinkage felt = linkage();
  felt.hold(LinkPart::Link1, {on_link1(felt, 0.5)});
  const Vector3d tip = felt.tip().m;
  felt.step({Vector3d::Constant(std::nan(""))}, true, kTick);
  EXPECT_EQ(felt.tip().m, tip);
  EXPECT_TRUE(felt.contact_force().N.isZero());
}

TEST(FeltLinkage, AHandThatWasLostHoldsNothingAndIsNotCaughtOnTheOtherSide) {
  FeltLinkage felt = linkage();
  const Vector3d middle = on_link1(felt, 0.5);
  Vector3d hand = middle + Vector3d(0, 0, 0.03);
  (void)go(felt, hand, middle + Vector3d(0, 0, 0.007), false, 200);
  felt.step({hand}, true, kTick);
  ASSERT_EQ(felt.held(), LinkPart::Link1);
  felt.forget_hand();
  EXPECT_TRUE(felt.contact_force().N.isZero());
  hand = middle - Vector3d(0, 0, 0.03);  // it came back on the other side, its button still pressed
  felt.step({hand}, true, kTick);
  EXPECT_TRUE(felt.contact_force().N.isZero());
  (void)go(felt, hand, middle - Vector3d(0, 0, 0.008), true, 200);
  EXPECT_EQ(felt.held(), std::nullopt);
  EXPECT_NEAR(felt.contact_force().N.z(), -0.001 * kSettings.stiffness_N_per_m, 1e-3);
}

TEST(FeltLinkage, AStepUsesNoHeap) {
  FeltLinkage felt = linkage();
  Vector3d hand = on_link1(felt, 0.5) + Vector3d(0, 0, 0.03);
  const Vector3d near = on_link1(felt, 0.5) + Vector3d(0, 0, 0.005);
  const test::NoHeapScope no_heap;
  (void)go(felt, hand, near, false, 100);
  FourBar other = felt.bar();
  other.l1_m += 0.002;
  felt.set(other);
  (void)go(felt, hand, near, true, 300);
  (void)go(felt, hand, near + Vector3d(0.01, 0.01, 0), true, 100);
  (void)go(felt, hand, hand, false, 100);
}

}  // namespace
}  // namespace telepalp::mechanism
