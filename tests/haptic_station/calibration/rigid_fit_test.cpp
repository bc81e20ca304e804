#include "haptic_station/calibration/rigid_fit.h"

#include <gtest/gtest.h>

#include <limits>

#include "haptic_station/device/random.h"

namespace telepalp::calibration {
namespace {

using Eigen::Vector3d;

Eigen::Isometry3d truth() {
  Eigen::Isometry3d iso = Eigen::Isometry3d::Identity();
  iso.linear() = Eigen::AngleAxisd(2.3, Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  iso.translation() = Vector3d{0.3, -0.8, 1.2};
  return iso;
}

Vector3d noise(device::Random& random, double sigma_m) {
  return sigma_m * Vector3d{random.normal(), random.normal(), random.normal()};
}

std::vector<PointPair> pairs_of(const std::vector<Vector3d>& points, double noise_m, int repeats, std::uint64_t seed) {
  device::Random random(seed);
  std::vector<PointPair> pairs;
  for (const Vector3d& point : points) {
    PointPair pair;
    for (int i = 0; i < repeats; ++i) {
      pair.from_m.push_back(point + noise(random, noise_m));
      pair.to_m.push_back(truth() * point + noise(random, noise_m));
    }
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<Vector3d> spread_points(std::size_t count, std::uint64_t seed) {
  device::Random random(seed);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({random.uniform(-0.15, 0.15), random.uniform(-0.1, 0.1), random.uniform(-0.15, 0.15)});
  return points;
}

TEST(RigidFit, FindsTheMotionExactlyWithoutNoise) {
  for (const auto& points :
       {spread_points(3, 1), spread_points(20, 2),
        std::vector<Vector3d>{{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.1, 0.1, 0.0}}}) {
    const Result<RigidFit> fit = fit_rigid(pairs_of(points, 0.0, 1, 1));
    ASSERT_TRUE(fit.ok()) << to_string(fit.error());
    EXPECT_LT((fit->to_from.matrix() - truth().matrix()).norm(), 1e-12);
    EXPECT_LT(fit->rms_residual_m, 1e-12);
  }
}

TEST(RigidFit, TenRepeatsOfTwelvePointsBeatThePapersError) {
  constexpr double kPapersError_m = 0.00135;
  constexpr double kTrackerNoise_m = 0.002;
  double sum_m = 0.0;
  double worst_m = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Result<RigidFit> fit = fit_rigid(pairs_of(spread_points(12, seed), kTrackerNoise_m, 10, seed));
    ASSERT_TRUE(fit.ok());
    EXPECT_NEAR(fit->repeat_sigma_m, kTrackerNoise_m, 0.0003);
    for (const Vector3d& target : spread_points(20, seed + 1000)) {
      const double error_m = (fit->to_from * target - truth() * target).norm();
      sum_m += error_m;
      worst_m = std::max(worst_m, error_m);
      ++count;
    }
  }
  EXPECT_LT(sum_m / count, 0.5 * kPapersError_m);
  EXPECT_LT(worst_m, 2.0 * kPapersError_m);
}

std::string complaint(const std::vector<PointPair>& pairs) {
  const Result<RigidFit> fit = fit_rigid(pairs);
  return fit.ok() ? "" : fit.error().what;
}

TEST(RigidFit, RefusesDegenerateSetsAndNamesTheirRank) {
  EXPECT_EQ(complaint(pairs_of(spread_points(2, 1), 0.0, 1, 1)), "2 point pairs");
  const std::vector<Vector3d> line{{0.0, 0.0, 0.0}, {0.1, 0.1, 0.0}, {0.2, 0.2, 0.0}, {0.3, 0.3, 0.0}};
  EXPECT_NE(complaint(pairs_of(line, 0.0005, 3, 1)).find("rank 1"), std::string::npos);
  const std::vector<Vector3d> place(5, Vector3d{0.1, 0.0, 0.0});
  EXPECT_NE(complaint(pairs_of(place, 0.0, 1, 1)).find("rank 0"), std::string::npos);
}

TEST(RigidFit, RefusesAMirroredFrame) {
  std::vector<PointPair> pairs = pairs_of(spread_points(8, 3), 0.0, 1, 1);
  for (PointPair& pair : pairs) pair.to_m[0].x() *= -1.0;
  EXPECT_NE(complaint(pairs).find("mirror"), std::string::npos);
}

TEST(RigidFit, RefusesWhatIsNotANumber) {
  std::vector<PointPair> pairs = pairs_of(spread_points(8, 3), 0.0, 1, 1);
  pairs[2].from_m[0].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint(pairs), "");
  pairs[2].from_m.clear();
  EXPECT_NE(complaint(pairs), "");
}

TEST(TrackerAboveTheDevice, MapsTheHandOntoTheEndEffector) {
  const auto haptic_from_tracker = haptic_from_tracker_at({{0.01, 0.2, 0.03}}, {{0.4, 0.0, 0.1}});
  EXPECT_LT(((haptic_from_tracker * Point<HandTracker>{{0.01, 0.2, 0.03}}).m - Vector3d{0.4, 0.0, 0.1}).norm(), 1e-15);
  const Vector<HapticBase> towards_tracker = haptic_from_tracker * Vector<HandTracker>{{0.0, -1.0, 0.0}};
  EXPECT_GT(towards_tracker.v.y(), 0.99) << "nearer to the tracker is higher";
}

}  // namespace
}  // namespace telepalp::calibration
