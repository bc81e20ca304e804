#include "server/capture/synthetic/synthetic_patient.h"
#include "where.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace telepalp::capture {
namespace {

/// One torso for all tests: reading and smoothing it takes longer than most of them.
const TriangleMesh& torso() {
  static const TriangleMesh mesh = [] {
    auto read = read_mesh(TELEPALP_SOURCE_DIR "/deploy/demo_data/torso/visible_human_torso.ply");
    EXPECT_TRUE(read.ok());
    return std::move(*read);
  }();
  return mesh;
}

SyntheticPatient patient(const SyntheticSettings& settings) {
  auto made = SyntheticPatient::make(torso(), settings);
  EXPECT_TRUE(made.ok());
  return std::move(*made);
}

SyntheticSettings exact() {
  SyntheticSettings settings;
  settings.noise = DepthNoise::None;
  settings.disparity_steps = false;
  settings.holes = false;
  settings.depth_unit_m = 0.0001;
  return settings;
}

const SyntheticPatient& exact_patient() {
  static const SyntheticPatient one = patient(exact());
  return one;
}

SessionTime at_seconds(double seconds) { return SessionTime{from_seconds(seconds)}; }

constexpr double kInhaled_s = 2.0;  // half a breath at 0.25 Hz

TEST(SyntheticPatient, IsReproducibleForASeedAndATime) {
  const SyntheticPatient one = patient({});
  const SyntheticPatient again = patient({});
  SyntheticSettings reseeded;
  reseeded.seed = 2;
  const SyntheticPatient other = patient(reseeded);
  const SessionTime time = at_seconds(1.7);
  const RgbdFrame frame = one.frame_at(time, 0);
  (void)again.frame_at(at_seconds(9.0), 0);  // earlier calls must have no effect
  EXPECT_EQ(frame.depth.samples, again.frame_at(time, 5).depth.samples);
  EXPECT_EQ(frame.color.rgb, again.frame_at(time, 5).color.rgb);
  EXPECT_NE(frame.depth.samples, other.frame_at(time, 0).depth.samples);
  EXPECT_NE(frame.depth.samples, one.frame_at(time + Nanoseconds{33'333'333}, 1).depth.samples);
}

TEST(SyntheticPatient, NoiseFreeDepthIsTheTrueSurfaceWithinATenthOfAMillimetre) {
  for (const double seconds : {0.0, 1.1, 2.0, 123.4}) {
    const RgbdFrame frame = exact_patient().frame_at(at_seconds(seconds), 0);
    ASSERT_TRUE(is_well_formed(frame));
    const TrueSurface truth = exact_patient().true_surface(at_seconds(seconds));
    double worst_m = 0.0;
    for (int v = 0; v < frame.depth.height; v += 3)
      for (int u = 0; u < frame.depth.width; u += 3)
        worst_m = std::max(worst_m, std::abs(frame.depth.at(u, v) * frame.depth.unit_m - truth.depth_m(u, v)));
    EXPECT_LT(worst_m, 0.0001) << "at " << seconds << " s";
  }
}

TEST(SyntheticPatient, TheBodyFillsMuchOfTheImageAtTheDistanceAskedFor) {
  const TrueSurface truth = exact_patient().true_surface(at_seconds(0.0));
  int body = 0;
  double nearest_m = 10.0;
  for (int v = 0; v < 480; v += 4)
    for (int u = 0; u < 640; u += 4) {
      const TrueSurfacePoint point = truth.at_pixel(u, v);
      body += point.on_body ? 1 : 0;
      nearest_m = std::min(nearest_m, point.at.m.z());
    }
  EXPECT_GT(body, 160 * 120 * 2 / 5);
  EXPECT_NEAR(nearest_m, 0.8, 0.005);
}

TEST(Breathing, LiftsTheBellyByItsAmplitudeAndComesBackExactly) {
  const double exhaled_m = exact_patient().true_surface(at_seconds(0.0)).depth_m(370, 240);
  const double inhaled_m = exact_patient().true_surface(at_seconds(kInhaled_s)).depth_m(370, 240);
  const double again_m = exact_patient().true_surface(at_seconds(4000.0)).depth_m(370, 240);
  EXPECT_NEAR(exhaled_m - inhaled_m, 0.005, 0.0006);
  EXPECT_NEAR(again_m, exhaled_m, 1e-9);
}

TEST(Breathing, LeavesArmsAndTableWhereTheyAre) {
  const TrueSurface before = exact_patient().true_surface(at_seconds(0.0));
  const TrueSurface after = exact_patient().true_surface(at_seconds(kInhaled_s));
  const TrueSurfacePoint forearm = before.at_pixel(330, 62);
  ASSERT_TRUE(forearm.on_body);
  EXPECT_NEAR(after.depth_m(330, 62), forearm.at.m.z(), 0.0002);
  ASSERT_FALSE(before.at_pixel(60, 40).on_body);
  EXPECT_EQ(after.depth_m(60, 40), before.depth_m(60, 40));
}

TEST(Breathing, SpeedIsTheRateOfChangeOfLift) {
  constexpr double kStep_s = 1e-4;
  for (double seconds = 0.05; seconds < 8.0; seconds += 0.37) {
    const Breath before = breath_at(at_seconds(seconds - kStep_s), 0.01, 0.3);
    const Breath after = breath_at(at_seconds(seconds + kStep_s), 0.01, 0.3);
    const Breath here = breath_at(at_seconds(seconds), 0.01, 0.3);
    EXPECT_NEAR(here.speed_m_per_s, (after.lift_m - before.lift_m) / (2.0 * kStep_s), 1e-6);
  }
}

TEST(TrueSurface, NormalIsAcrossTheSurfaceAndTowardsTheCamera) {
  const TrueSurface truth = exact_patient().true_surface(at_seconds(1.3));
  std::mt19937 random{7};
  std::uniform_real_distribution<double> across{150.0, 440.0};
  std::uniform_real_distribution<double> down{170.0, 310.0};
  for (int i = 0; i < 200; ++i) {
    const double u = across(random);
    const double v = down(random);
    const TrueSurfacePoint point = truth.at_pixel(u, v);
    ASSERT_TRUE(point.on_body);
    EXPECT_NEAR(point.normal.v.norm(), 1.0, 1e-12);
    EXPECT_LT(point.normal.v.dot(point.at.m), 0.0);
    const Eigen::Vector3d along_u = truth.at_pixel(u + 1e-4, v).at.m - truth.at_pixel(u - 1e-4, v).at.m;
    const Eigen::Vector3d along_v = truth.at_pixel(u, v + 1e-4).at.m - truth.at_pixel(u, v - 1e-4).at.m;
    EXPECT_NEAR(point.normal.v.dot(along_u.normalized()), 0.0, 1e-5);
    EXPECT_NEAR(point.normal.v.dot(along_v.normalized()), 0.0, 1e-5);
  }
}

TEST(TrueSurface, NormalVelocityIsTheSurfacesSpeedAlongItsNormal) {
  constexpr double kStep_s = 1e-4;
  for (const double seconds : {0.6, 1.4, 2.7, 3.3}) {
    const TrueSurfacePoint here = exact_patient().true_surface(at_seconds(seconds)).at_pixel(370, 240);
    const Point<DepthCamera> probe = here.at;
    const auto before = exact_patient().true_surface(at_seconds(seconds - kStep_s)).signed_distance_m(probe);
    const auto after = exact_patient().true_surface(at_seconds(seconds + kStep_s)).signed_distance_m(probe);
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(here.normal_velocity_m_per_s, -(*after - *before) / (2.0 * kStep_s), 2e-6);
  }
}

TEST(TrueSurface, AStepAlongTheNormalChangesTheSignedDistanceByItsLength) {
  const TrueSurface truth = exact_patient().true_surface(at_seconds(0.9));
  std::mt19937 random{11};
  std::uniform_real_distribution<double> across{150.0, 440.0};
  std::uniform_real_distribution<double> down{180.0, 300.0};
  std::uniform_real_distribution<double> off_m{-0.01, 0.03};
  for (int i = 0; i < 200; ++i) {
    const TrueSurfacePoint foot = truth.at_pixel(across(random), down(random));
    const double distance_m = off_m(random);
    const Point<DepthCamera> point{foot.at.m + distance_m * foot.normal.v};
    const auto found = truth.closest_to(point);
    ASSERT_TRUE(found) << "sample " << i;
    EXPECT_NEAR(*truth.signed_distance_m(point), distance_m, 1e-7);
    EXPECT_LT((found->at.m - foot.at.m).norm(), 1e-6);
  }
}

TEST(TrueSurface, PointAtXYLiesOnTheSurfaceAboveThatXY) {
  const TrueSurface truth = exact_patient().true_surface(at_seconds(2.0));
  for (double x_m = -0.25; x_m <= 0.25; x_m += 0.05)
    for (double y_m = -0.08; y_m <= 0.08; y_m += 0.04) {
      const auto point = truth.at_xy(x_m, y_m);
      ASSERT_TRUE(point) << x_m << ", " << y_m;
      EXPECT_NEAR(point->at.m.x(), x_m, 1e-9);
      EXPECT_NEAR(point->at.m.y(), y_m, 1e-9);
      EXPECT_NEAR(truth.on_ray_through(point->at).at.m.z(), point->at.m.z(), 1e-9);
    }
}

TEST(TrueSurface, BellyIsFreeOfFacets) {
  // With facets of 13 mm, the normal would change by degrees within a pixel at their edges.
  const TrueSurface truth = exact_patient().true_surface(at_seconds(0.0));
  double worst_rad = 0.0;
  for (int v = 190; v < 290; ++v)
    for (int u = 250; u < 420; ++u) {
      const Eigen::Vector3d here = truth.at_pixel(u, v).normal.v;
      worst_rad = std::max(worst_rad, here.cross(truth.at_pixel(u + 1, v).normal.v).norm());
      worst_rad = std::max(worst_rad, here.cross(truth.at_pixel(u, v + 1).normal.v).norm());
    }
  EXPECT_LT(worst_rad, 0.035) << "2 degrees";
}

/// Mean and standard deviation of the depth error over the belly [m].
struct Scatter {
  double mean_m = 0.0;
  double sigma_m = 0.0;
};
Scatter scatter_of(const SyntheticPatient& noisy) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int k = 0; k < 4; ++k) {
    const SessionTime time = at_seconds(0.1 * k);
    const RgbdFrame frame = noisy.frame_at(time, 0);
    const TrueSurface truth = noisy.true_surface(time);
    for (int v = 200; v < 280; ++v)
      for (int u = 260; u < 420; ++u) {
        const double error = frame.depth.at(u, v) * frame.depth.unit_m - truth.depth_m(u, v);
        sum += error;
        squares += error * error;
        ++count;
      }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean)};
}

TEST(DepthNoise, HasTheKinectsSigma) {
  SyntheticSettings settings = exact();
  settings.noise = DepthNoise::Kinect;
  const double z_m = 0.81;
  const double expected_m = 0.0012 + 0.0019 * (z_m - 0.4) * (z_m - 0.4);
  const Scatter scatter = scatter_of(patient(settings));
  EXPECT_NEAR(scatter.sigma_m, expected_m, 0.03 * expected_m);
  EXPECT_NEAR(scatter.mean_m, 0.0, 0.00005);
}

TEST(DepthNoise, HasTheGaussianSigmaAskedFor) {
  SyntheticSettings settings = exact();
  settings.noise = DepthNoise::Gaussian;
  settings.gaussian_sigma_m = 0.0005;
  EXPECT_NEAR(scatter_of(patient(settings)).sigma_m, 0.0005, 0.00002);
}

TEST(DepthSteps, AreAsLargeAsTheKinects) {
  SyntheticSettings settings = exact();
  settings.disparity_steps = true;
  const SyntheticPatient stepped = patient(settings);
  const RgbdFrame frame = stepped.frame_at(at_seconds(0.0), 0);
  std::vector<std::uint16_t> levels = frame.depth.samples;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  EXPECT_GT(levels.size(), 60u);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const double z_m = 0.5 * (levels[i] + levels[i - 1]) * frame.depth.unit_m;
    const double spacing_m = (levels[i] - levels[i - 1]) * frame.depth.unit_m;
    const double steps = spacing_m / (0.00285 * z_m * z_m);
    EXPECT_NEAR(steps, std::round(steps), 0.12) << "at " << z_m << " m";  // the unit of 0.1 mm rounds
  }
  const TrueSurface truth = stepped.true_surface(at_seconds(0.0));
  for (int u = 200; u < 440; ++u)
    EXPECT_NEAR(frame.depth.at(u, 240) * frame.depth.unit_m, truth.depth_m(u, 240), 0.00285 * 0.9 * 0.9 / 2.0);
}

TEST(Holes, LieAlongSilhouettesAndLeaveTheBellyWhole) {
  const RgbdFrame frame = patient({}).frame_at(at_seconds(0.0), 0);
  int holes = 0;
  for (const std::uint16_t sample : frame.depth.samples) holes += sample == 0 ? 1 : 0;
  EXPECT_GT(holes, 307200 / 100);
  EXPECT_LT(holes, 307200 / 10);
  for (int v = 200; v < 280; ++v)
    for (int u = 200; u < 420; ++u) ASSERT_NE(frame.depth.at(u, v), 0) << u << ", " << v;
}

TEST(SyntheticPatient, WorksForAnotherCamera) {
  SyntheticSettings settings = exact();
  settings.camera = {320, 240, 262.5, 262.5, 159.5, 119.5};
  const SyntheticPatient small = patient(settings);
  const RgbdFrame frame = small.frame_at(at_seconds(0.0), 0);
  EXPECT_TRUE(is_well_formed(frame));
  EXPECT_NEAR(frame.depth.at(160, 120) * frame.depth.unit_m, small.true_surface(at_seconds(0.0)).depth_m(160, 120),
              0.0001);
}

TEST(SyntheticPatient, RefusesAnInvalidMeshOrSetting) {
  TriangleMesh in_millimetres = torso();
  for (Eigen::Vector3f& vertex : in_millimetres.vertices) vertex *= 1000.0F;
  const auto huge = SyntheticPatient::make(in_millimetres, {}, "mm.ply");
  ASSERT_FALSE(huge.ok());
  EXPECT_NE(to_string(huge.error()).find("metres"), std::string::npos);
  SyntheticSettings wild;
  wild.amplitude_m = 5.0;  // millimetres given for metres
  const auto gasping = SyntheticPatient::make(torso(), wild);
  ASSERT_FALSE(gasping.ok());
  EXPECT_NE(to_string(gasping.error()).find("amplitude_m"), std::string::npos);
}

}  // namespace
}  // namespace telepalp::capture
