#include "haptic_station/tissue/fem/prism_touch.h"

#include "tests/haptic_station/tissue/fem/prisms.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

constexpr double kPeriod_s = 0.016;

/// A coarse prism, quick to step, whose right side is at x = 10 mm and whose top is at y = 100 mm.
PrismSettings coarse() { return {.grid = {.across = 1, .along = 4}, .spread_m = 0.01}; }

/// A tool that has moved to `at_m` and rests there.
struct Touched {
  explicit Touched(const PrismSettings& settings = coarse()) : touch(*make_prism_model(settings)) {}
  LocalPlane move(const Vector3d& to_m, int steps = 20) {
    const Vector3d from_m = at_m;
    LocalPlane plane;
    for (int i = 1; i <= steps; ++i) plane = touch.step(from_m + (to_m - from_m) * i / steps, kPeriod_s).value();
    at_m = to_m;
    return plane;
  }
  LocalPlane rest(int steps) {
    LocalPlane plane;
    for (int i = 0; i < steps; ++i) plane = touch.step(at_m, kPeriod_s).value();
    return plane;
  }
  PrismTouch touch;
  Vector3d at_m{0.03, 0.09, 0.0};
};

TEST(PrismTouch, FarAwayThereIsNothing) {
  PrismTouch touch(*make_prism_model(coarse()));
  EXPECT_TRUE(touch.step({0.2, 0.09, 0.0}, kPeriod_s)->normal.isZero(0.0));
}

TEST(PrismTouch, BeforeTheSideThePlaneIsTheSide) {
  Touched touched;
  const LocalPlane plane = touched.move({0.015, 0.08, 0.0});
  EXPECT_FALSE(plane.in_contact);
  EXPECT_LT((plane.normal - Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_NEAR(plane.offset_m, 0.01, 1e-9);
  EXPECT_TRUE(plane.usable());
}

TEST(PrismTouch, BesideTheTopsEdgeThePlaneIsNotTheSide) {
  Touched touched;
  const LocalPlane plane = touched.move({0.012, 0.104, 0.0});
  EXPECT_EQ(plane.force_N({0.005, 0.104, 0.0}), 0.0) << "a tool above the top passes over it";
}

TEST(PrismTouch, APressedSidePushesBackAndThePrismLeans) {
  Touched touched;
  touched.move({0.0, 0.09, 0.0}, 60);
  const LocalPlane plane = touched.rest(60);
  ASSERT_EQ(touched.touch.contact(), PrismContact::Pressed);
  EXPECT_GT(plane.normal.x(), 0.9);
  EXPECT_NEAR(plane.force_N(touched.at_m), touched.touch.pressed_N(), 0.1 * touched.touch.pressed_N())
      << "the plane's force is that of the contact";
  EXPECT_LT(place_of(top_of(touched.touch.motion().body().mesh()), touched.touch.motion().at()).x(), -0.005);
}

/// The hand-over's stiffness against the difference of two forces in equilibrium.
TEST(PrismTouch, ItsStiffnessIsTheSlopeOfItsForce) {
  Touched touched;
  touched.move({0.002, 0.085, 0.0}, 40);
  const LocalPlane before = touched.rest(80);
  const double force_N = before.force_N(touched.at_m);
  touched.move({0.001, 0.085, 0.0}, 10);
  const LocalPlane after = touched.rest(80);
  const double slope = (after.force_N(touched.at_m) - force_N) / 0.001;
  EXPECT_NEAR(before.stiffness_N_per_m * before.normal.x() / slope, 1.0, 0.03);
  EXPECT_NEAR(before.force_N(touched.at_m) / after.force_N(touched.at_m), 1.0, 0.01) << "it foretells the next force";
}

TEST(PrismTouch, ACouplingIsInSeries) {
  PrismSettings settings = coarse();
  settings.coupling_N_per_m = 200.0;
  Touched coupled(settings);
  Touched rigid;
  coupled.move({0.0, 0.09, 0.0}, 60);
  rigid.move({0.0, 0.09, 0.0}, 60);
  const LocalPlane soft = coupled.rest(60);
  const LocalPlane hard = rigid.rest(60);
  EXPECT_LT(soft.stiffness_N_per_m, 200.0);
  EXPECT_NEAR(1.0 / soft.stiffness_N_per_m, 1.0 / hard.stiffness_N_per_m + 1.0 / 200.0, 1e-4);
  EXPECT_LT(soft.force_N(coupled.at_m), 2.0);
}

TEST(PrismTouch, LeavesThroughTheSideItCameFrom) {
  Touched touched;
  touched.move({0.004, 0.09, 0.0}, 30);
  ASSERT_EQ(touched.touch.contact(), PrismContact::Pressed);
  touched.move({0.03, 0.09, 0.0}, 30);
  EXPECT_EQ(touched.touch.contact(), PrismContact::Free);
  touched.rest(100);
  EXPECT_LT(away_m(touched.touch.motion()), 1e-7);
}

/// The prism springs back faster than the hand leaves.
TEST(PrismTouch, AToolThatLeavesIsNeverPulled) {
  Touched touched;
  touched.move({0.0, 0.09, 0.0}, 60);
  touched.rest(30);
  for (int i = 1; i <= 20; ++i) {
    const LocalPlane plane = touched.move({0.0016 * i, 0.09, 0.0}, 1);
    EXPECT_GT(plane.normal.x(), 0.9) << "step " << i;
  }
  EXPECT_EQ(touched.touch.contact(), PrismContact::Free);
}

TEST(PrismTouch, SlidesOffOverTheTop) {
  Touched touched;
  touched.move({0.006, 0.095, 0.0}, 30);
  ASSERT_EQ(touched.touch.contact(), PrismContact::Pressed);
  touched.move({0.006, 0.12, 0.0}, 30);
  EXPECT_EQ(touched.touch.contact(), PrismContact::Free);
}

TEST(PrismTouch, LetsGoOfAHandThatPassesThrough) {
  PrismSettings settings = coarse();
  settings.lets_go_N = 10.0;
  Touched touched(settings);
  touched.move({-0.03, 0.06, 0.0}, 30);
  EXPECT_NE(touched.touch.contact(), PrismContact::Pressed);
  touched.move({-0.05, 0.06, 0.0}, 10);
  touched.rest(30);
  EXPECT_EQ(touched.touch.contact(), PrismContact::Free);
  EXPECT_LT(touched.move({-0.015, 0.06, 0.0}, 10).normal.x(), -0.99) << "it can be touched from the other side";
}

TEST(PrismTouch, AToolThatBeginsInsideIsNotPushed) {
  PrismTouch touch(*make_prism_model(coarse()));
  EXPECT_TRUE(touch.step({0.0, 0.05, 0.0}, kPeriod_s)->normal.isZero(0.0));
  EXPECT_EQ(touch.contact(), PrismContact::Passed);
}

TEST(PrismTouch, AfterItDivergedItBeginsAtRest) {
  Touched touched;
  touched.move({0.004, 0.09, 0.0}, 30);
  NodeField bad = touched.touch.motion().at();
  bad(1, 2) = std::nan("");
  touched.touch.disturb(bad);
  EXPECT_FALSE(touched.touch.step(touched.at_m, kPeriod_s).has_value());
  EXPECT_EQ(away_m(touched.touch.motion()), 0.0);
  EXPECT_TRUE(touched.touch.step({0.03, 0.09, 0.0}, kPeriod_s).has_value());
  EXPECT_FALSE(touched.touch.step({std::nan(""), 0.0, 0.0}, kPeriod_s).has_value());
}

TEST(PrismTouch, StandsOnItsFoot) {
  PrismSettings settings = coarse();
  settings.foot_m = {0.1, -0.12, 0.02};
  PrismTouch touch(*make_prism_model(settings));
  const LocalPlane plane = touch.step({0.115, -0.04, 0.02}, kPeriod_s).value();
  EXPECT_NEAR(plane.offset_m, 0.11, 1e-9);
  EXPECT_LT((plane.at_m - Vector3d(0.11, -0.04, 0.02)).norm(), 1e-9);
}

}  // namespace
}  // namespace telepalp::tissue
