#include <gtest/gtest.h>

#include <limits>

#include "haptic_station/calibration/hand_on_probe.h"
#include "haptic_station/calibration/offset_procedure.h"
#include "haptic_station/device/random.h"

namespace telepalp::calibration {
namespace {

using Eigen::Vector3d;

std::vector<Touch> still_touches(int count, double noise_m) {
  device::Random random(3);
  std::vector<Touch> touches;
  for (int i = 0; i < count; ++i) {
    const Vector3d noise = Vector3d(random.normal(), random.normal(), random.normal()) * noise_m;
    touches.push_back({{Vector3d(0.02, 0.18, 0.03) + noise}, {{0.0, 0.05, 0.01}}});
  }
  return touches;
}

TEST(OffsetProcedure, MapsTheTouchToTheEndEffectorAndTurnsTheAxesAsEquation4) {
  const Result<OffsetCalibration> fit = calibrate_offset(still_touches(100, 0.0));
  ASSERT_TRUE(fit) << to_string(fit.error());
  const auto& haptic_from_tracker = fit->haptic_from_tracker;
  const Point<HapticBase> touch = haptic_from_tracker * Point<HandTracker>{{0.02, 0.18, 0.03}};
  EXPECT_LT((touch.m - Vector3d(0.0, 0.05, 0.01)).norm(), 1e-12);
  const Vector<HapticBase> way = haptic_from_tracker * Vector<HandTracker>{{1, 2, 3}};
  EXPECT_LT((way.v - Vector3d(1, -2, -3)).norm(), 1e-12);
}

TEST(OffsetProcedure, ItsInverseIsEquation3) {
  const Result<OffsetCalibration> fit = calibrate_offset(still_touches(100, 0.0));
  ASSERT_TRUE(fit);
  const Point<HapticBase> p{{0.04, 0.02, -0.07}};
  const Vector3d by_hand =
      Vector3d(1, -1, -1).asDiagonal() * (p.m - Vector3d(0.0, 0.05, 0.01)) + Vector3d(0.02, 0.18, 0.03);
  EXPECT_LT(((fit->haptic_from_tracker.inverse() * p).m - by_hand).norm(), 1e-12);
}

TEST(OffsetProcedure, AveragesTheNoiseOfTheTracker) {
  const Result<OffsetCalibration> fit = calibrate_offset(still_touches(100, 0.5e-3));
  ASSERT_TRUE(fit) << to_string(fit.error());
  const Point<HapticBase> touch = fit->haptic_from_tracker * Point<HandTracker>{{0.02, 0.18, 0.03}};
  EXPECT_LT((touch.m - Vector3d(0.0, 0.05, 0.01)).norm(), 0.2e-3);
  EXPECT_GT(fit->residuals.mean_m(), 0.4e-3);
}

TEST(OffsetProcedure, RefusesTooFewTouchesAHandThatMovedAndWhatIsNotFinite) {
  EXPECT_FALSE(calibrate_offset({}));
  EXPECT_FALSE(calibrate_offset({}, {.least_touches = 0}));
  EXPECT_FALSE(calibrate_offset(still_touches(9, 0.0)));
  std::vector<Touch> moved = still_touches(50, 0.0);
  moved.back().hand.m.x() += 0.02;
  const Result<OffsetCalibration> fit = calibrate_offset(moved);
  ASSERT_FALSE(fit);
  EXPECT_NE(fit.error().what.find("20 mm"), std::string::npos) << fit.error().what;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    std::vector<Touch> touches = still_touches(50, 0.0);
    touches[7].end_effector.m.y() = bad;
    EXPECT_FALSE(calibrate_offset(touches));
  }
}

Eigen::Isometry3d pose(device::Random& random, double reach_m, double turn_rad) {
  const Vector3d axis = Vector3d(random.normal(), random.normal(), random.normal()).normalized();
  const Vector3d at = Vector3d(random.normal(), random.normal(), random.normal()) * reach_m;
  return Eigen::Translation3d(at) * Eigen::AngleAxisd(turn_rad, axis);
}

struct ProbeScene {
  Eigen::Isometry3d haptic_from_tracker;
  Eigen::Isometry3d probe_from_hand;
  std::vector<HandOnProbe> poses;
};

ProbeScene probe_scene(int count, double noise_m, double noise_rad) {
  device::Random random(9);
  ProbeScene scene{pose(random, 0.5, 2.0), pose(random, 0.05, 0.7), {}};
  for (int i = 0; i < count; ++i) {
    const Eigen::Isometry3d haptic_from_probe = pose(random, 0.05, 0.1);
    const Eigen::Isometry3d seen = scene.haptic_from_tracker.inverse() * haptic_from_probe * scene.probe_from_hand;
    scene.poses.push_back({seen * pose(random, noise_m, noise_rad), haptic_from_probe});
  }
  return scene;
}

TEST(HandOnProbe, OnePoseIsEnough) {
  const ProbeScene scene = probe_scene(1, 0.0, 0.0);
  const auto fit = calibrate_hand_on_probe(scene.poses, scene.probe_from_hand);
  ASSERT_TRUE(fit) << to_string(fit.error());
  EXPECT_LT((fit->haptic_from_tracker.matrix() - scene.haptic_from_tracker.matrix()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(HandOnProbe, RepeatsAverageTheTrackersNoise) {
  const ProbeScene scene = probe_scene(50, 1e-3, 0.03);
  const auto fit = calibrate_hand_on_probe(scene.poses, scene.probe_from_hand);
  ASSERT_TRUE(fit) << to_string(fit.error());
  const Eigen::Matrix3d difference = fit->haptic_from_tracker.linear() * scene.haptic_from_tracker.linear().transpose();
  EXPECT_LT(Eigen::AngleAxisd(difference).angle(), 0.01);
  EXPECT_GT(fit->residuals.mean_m(), 0.5e-3);
  EXPECT_EQ(fit->angles_rad.size(), 50u);
}

TEST(HandOnProbe, RefusesMirrorsScalesNoPoseAndPosesThatDisagree) {
  const ProbeScene scene = probe_scene(3, 0.0, 0.0);
  EXPECT_FALSE(calibrate_hand_on_probe({}, scene.probe_from_hand));
  ProbeScene mirrored = scene;
  mirrored.poses[1].tracker_from_hand.linear().col(0) *= -1.0;
  EXPECT_NE(calibrate_hand_on_probe(mirrored.poses, scene.probe_from_hand).error().what.find("mirrored"),
            std::string::npos);
  ProbeScene scaled = scene;
  scaled.poses[1].haptic_from_probe.linear() *= 1.1;
  EXPECT_FALSE(calibrate_hand_on_probe(scaled.poses, scene.probe_from_hand));
  ProbeScene turned = scene;
  turned.poses[2].tracker_from_hand.rotate(Eigen::AngleAxisd(1.5, Vector3d::UnitZ()));
  EXPECT_NE(calibrate_hand_on_probe(turned.poses, scene.probe_from_hand).error().what.find("degrees"),
            std::string::npos);
  ProbeScene opposed = probe_scene(1, 0.0, 0.0);
  opposed.poses.push_back(opposed.poses[0]);
  opposed.poses[1].tracker_from_hand.rotate(Eigen::AngleAxisd(3.14159265358979, Vector3d::UnitZ()));
  EXPECT_NE(calibrate_hand_on_probe(opposed.poses, scene.probe_from_hand).error().what.find("opposite directions"),
            std::string::npos);
  ProbeScene lost = scene;
  lost.poses[0].tracker_from_hand.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(calibrate_hand_on_probe(lost.poses, scene.probe_from_hand));
}

}  // namespace
}  // namespace telepalp::calibration
