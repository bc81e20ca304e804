#include <gtest/gtest.h>

#include <cmath>

#include "tests/clients/mixed/anchored_headset.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;

TEST(HeadsetAnchor, ThreeTouchesPlaceThePatientAndFiveAPointTwiceAsWell) {
  const AnchorError one = anchor_error(0.2, 1, Gravity::Unknown, 400),
                    five = anchor_error(0.2, 5, Gravity::Unknown, 400);
  EXPECT_LE(one.at_m, 1.5e-3);
  EXPECT_LE(five.at_m, 0.65e-3);
  EXPECT_LT(anchor_error(0.2, 1, Gravity::Known, 400).turn_rad, 0.7 * one.turn_rad);
  EXPECT_GT(anchor_error(0.1, 1, Gravity::Unknown, 400).turn_rad, 1.5 * one.turn_rad);
}

TEST(HeadsetAnchor, WithoutNoiseItIsExactAndProper) {
  const Eigen::Isometry3d truth = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(2.5, Vector3d::UnitY());
  std::vector<Touch> touches;
  for (const Vector3d& known : {Vector3d(0, 0, 0), Vector3d(0.2, 0, 0), Vector3d(0, 0, 0.25)})
    touches.push_back({static_cast<int>(touches.size()), {known}, {truth * known}});
  for (const Gravity gravity : {Gravity::Unknown, Gravity::Known}) {
    const Result<HeadsetAnchor> anchor = anchor_headset(touches, gravity);
    ASSERT_TRUE(anchor) << to_string(anchor.error());
    EXPECT_LT((anchor->headset_from_haptic.iso.matrix() - truth.matrix()).norm(), 1e-9);
  }
}

TEST(HeadsetAnchor, RefusesTouchesFromWhichNoPlaceFollows) {
  EXPECT_NE(anchor_headset({}, Gravity::Known).error().what.find("only 0 places"), std::string::npos);
  std::vector<Touch> line;
  for (int i = 0; i < 3; ++i) line.push_back({i, {{0.1 * i, 0, 0}}, {{0.1 * i, 0, 0}}});
  EXPECT_NE(anchor_headset(line, Gravity::Known).error().what.find("on a line"), std::string::npos);
  line[1].known.m.z() = 0.2;  // seen elsewhere than known
  EXPECT_NE(anchor_headset(line, Gravity::Unknown).error().what.find("miss their places"), std::string::npos);
  line[0].touched.m.x() = std::nan("");
  EXPECT_NE(anchor_headset(line, Gravity::Known).error().what.find("not finite"), std::string::npos);
}

TEST(PivotTip, IsFoundFromPosesAboutARestingTip) {
  const Vector3d tip(0.01, -0.02, 0.12), rest(0.3, 1.0, -0.2);
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 8; ++i) {
    Eigen::Isometry3d pose(Eigen::AngleAxisd(0.5, Vector3d(std::cos(i), 0.3, std::sin(i)).normalized()));
    pose.translation() = rest - pose.linear() * tip;
    poses.push_back(pose);
  }
  const Result<Vector3d> found = pivot_tip(poses);
  ASSERT_TRUE(found) << to_string(found.error());
  EXPECT_LT((*found - tip).norm(), 1e-9);
  EXPECT_FALSE(pivot_tip(std::vector<Eigen::Isometry3d>(8, poses.front())));
}

}  // namespace
}  // namespace telepalp::mixed
