#include "haptic_station/calibration/point_registration.h"

#include <gtest/gtest.h>

#include "haptic_station/calibration/pair_file.h"
#include "tests/haptic_station/calibration/registration_trial.h"

namespace telepalp::calibration {
namespace {

TEST(PointRegistration, BeatsThePapersErrorUnderThePapersNoise) {
  // S3 measured residuals of 1.35 +- 0.58 mm. Here this is the noise of every single click.
  const TrialErrors errors = registration_errors({.places = 8, .repeats = 3, .noise_m = kPaperNoise_m},
                                                 RotationBy::Covariance, 500, /*seed=*/1);
  EXPECT_NEAR(errors.noise.mean_m(), 1.35e-3, 0.03e-3);
  EXPECT_NEAR(errors.noise.deviation_m(), 0.58e-3, 0.03e-3);
  EXPECT_LT(errors.at_targets.mean_m(), 0.5e-3);
  EXPECT_LT(errors.at_targets.deviation_m(), 0.3e-3);
}

TEST(PointRegistration, IsNoWorseThanThePapersAffineFitOnTheSameSeeds) {
  const RegistrationTrial trial{.places = 6, .repeats = 1, .noise_m = kPaperNoise_m};
  const TrialErrors ours = registration_errors(trial, RotationBy::Covariance, 500, 7);
  const TrialErrors papers = registration_errors(trial, RotationBy::AffinePolar, 500, 7);
  EXPECT_LT(ours.at_targets.mean_m(), papers.at_targets.mean_m());
}

TEST(PointRegistration, RepeatsLowerTheErrorAsTheirSquareRoot) {
  const TrialErrors once =
      registration_errors({.places = 8, .repeats = 1, .noise_m = kPaperNoise_m}, RotationBy::Covariance, 500, 3);
  const TrialErrors nine =
      registration_errors({.places = 8, .repeats = 9, .noise_m = kPaperNoise_m}, RotationBy::Covariance, 500, 3);
  EXPECT_NEAR(once.at_targets.mean_m() / nine.at_targets.mean_m(), 3.0, 0.3);
}

TEST(PointRegistration, WithoutNoiseEveryMotionIsFoundExactly) {
  const TrialErrors errors =
      registration_errors({.places = 4, .repeats = 1, .noise_m = 0.0}, RotationBy::Covariance, 500, 11);
  EXPECT_LT(errors.at_targets.largest_m(), 1e-12);
}

TEST(PointRegistration, NamesTheWorstPair) {
  device::Random random(5);
  std::vector<PointPair> pairs = make_pairs({.places = 8, .repeats = 1, .noise_m = 1e-4}, random).pairs;
  pairs[5].to.x() += 0.01;
  const Result<Registration> fit = register_points(pairs);
  ASSERT_TRUE(fit) << to_string(fit.error());
  EXPECT_EQ(fit->residuals.worst(), 5u);
}

constexpr std::string_view kHeader = "place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m\n";

TEST(PairFile, ReadsRowsAndRepeats) {
  const auto pairs = parse_point_pairs(std::string(kHeader) + "1,0.1,0,0,0.2,0,0\r\n\n1,0.1,0,0,0.2,0,1e-3\n", "p.csv");
  ASSERT_TRUE(pairs) << to_string(pairs.error());
  ASSERT_EQ(pairs->size(), 2u);
  EXPECT_EQ((*pairs)[1].place, 1);
  EXPECT_DOUBLE_EQ((*pairs)[1].from.z(), 1e-3);
}

TEST(PairFile, NamesTheLineOfANumberThatIsNotFinite) {
  for (const char* row : {"1,0,1,0,0,0,2,0,0,0,0,0,0", "1,nan,0,0,0,0,0", "1,inf,0,0,0,0,0", "1.5,0,0,0,0,0,0", "1,2",
                          "1,0,0,0,0,0,0,", "x,0,0,0,0,0,0", "1, 0,0,0,0,0,0", "1e9,0,0,0,0,0,0"}) {
    const auto pairs = parse_point_pairs(std::string(kHeader) + "1,0,0,0,0,0,0\n" + row + "\n", "p.csv");
    ASSERT_FALSE(pairs) << row;
    EXPECT_EQ(pairs.error().where, "p.csv:3") << row;
  }
  EXPECT_FALSE(parse_point_pairs("a,b\n", "p.csv"));
  EXPECT_FALSE(read_point_pairs("/nowhere/p.csv"));
}

}  // namespace
}  // namespace telepalp::calibration
