#include "haptic_station/calibration/pose_file.h"
#include "where.h"

#include <gtest/gtest.h>

#include <string>

namespace telepalp::calibration {
namespace {

std::string rows(const std::string& body) { return std::string(kPoseHeader) + "\n" + body; }

TEST(PoseFile, ReadsAPoseOfEachInItsOwnFrame) {
  const auto poses = parse_hand_on_probe(rows("1,2,3,0,0,1.5707963267948966,4,5,6,0,0,0\r\n\n"), "p.csv");
  ASSERT_TRUE(poses.ok()) << to_string(poses.error());
  ASSERT_EQ(poses->size(), 1U);
  EXPECT_LT(((*poses)[0].tracker_from_hand * Eigen::Vector3d::UnitX() - Eigen::Vector3d(1, 3, 3)).norm(), 1e-12);
  EXPECT_LT(((*poses)[0].haptic_from_probe.translation() - Eigen::Vector3d(4, 5, 6)).norm(), 1e-12);
}

TEST(PoseFile, AnInvalidRowIsAnErrorWithItsLine) {
  for (const char* bad : {"1,2,3", "1,2,3,0,0,0,4,5,6,0,0,nan", "1;2;3;0;0;0;4;5;6;0;0;0", "a,2,3,0,0,0,4,5,6,0,0,0",
                          "1,2,3,0,0,0,4,5,6,0,0,0,7"}) {
    const auto poses = parse_hand_on_probe(rows("0,0,0,0,0,0,0,0,0,0,0,0\n" + std::string(bad)), "p.csv");
    ASSERT_FALSE(poses.ok()) << bad;
    EXPECT_EQ(poses.error().where, "p.csv:3") << bad;
  }
  EXPECT_FALSE(parse_hand_on_probe("1,2,3\n", "p.csv").ok());
  EXPECT_FALSE(read_hand_on_probe("/nowhere.csv").ok());
  EXPECT_FALSE(parse_pose("1,2,3").has_value());
}

TEST(PoseFile, TheOneThatShipsIsCalibrated) {
  const auto poses = read_hand_on_probe(TELEPALP_SOURCE_DIR "/deploy/demo_data/calibration/poses.csv");
  ASSERT_TRUE(poses.ok()) << to_string(poses.error());
  const auto fit = calibrate_hand_on_probe(*poses, Eigen::Isometry3d::Identity());
  ASSERT_TRUE(fit.ok()) << to_string(fit.error());
  EXPECT_LT((fit->haptic_from_tracker.translation() - Eigen::Vector3d(0.05, 0.45, 0.10)).norm(), 0.003);
}

}  // namespace
}  // namespace telepalp::calibration
