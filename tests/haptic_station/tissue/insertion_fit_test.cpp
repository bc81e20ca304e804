#include "haptic_station/tissue/fit/insertion_fit.h"

#include <gtest/gtest.h>

#include <limits>

#include "haptic_station/tissue/fit/rising_pieces.h"
#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::tissue {
namespace {

/// A needle in a tissue that no fit has made, with noise of 5 mN, as in measured curves; 3 mm of air before it.
InsertionCurve insertion_into(const TissueSettings& settings, std::uint64_t seed) {
  device::Random random(seed);
  Insertion run(settings, {0.0, 0.003, 0.0});
  InsertionCurve curve;
  for (int i = 0; i < 24'000; ++i) {
    run.tick(run.needle.tip_m - Eigen::Vector3d(0.0, 2.5e-6, 0.0));  // 5 mm/s
    if (i % 8 != 0) continue;
    curve.depth_m.push_back(-run.needle.tip_m.y());
    curve.force_N.push_back(run.force_N.y() + 0.005 * random.normal());
  }
  return curve;
}

TissueSettings liver() {
  TissueSettings tissue = one_surface(1.4, 0.0);
  tissue.layers[0].surface->stiffness_N_per_m = 60.0;
  tissue.layers[0].surface->stiffening_N_per_m2 = 5000.0;
  tissue.layers[0].thickness_m = 0.03;
  tissue.layers[0].bulk = BulkSettings{.slips_at_N = 0.0, .slips_at_N_per_m = 11.0, .cuts_at_N = 0.4};
  tissue.layers.push_back(
      {.name = "vessel", .top_m = 0.03, .thickness_m = 0.04, .surface = {}, .bulk = {}, .relaxation = {}});
  tissue.layers[1].bulk = BulkSettings{.slips_at_N = 0.0, .slips_at_N_per_m = 14.0, .cuts_at_N = 0.9};
  return tissue;
}

TEST(InsertionFit, MeetsANeedleInATissueThatItHasNotMadeAndFindsItsPuncture) {
  for (const std::uint64_t seed : {1, 2}) {
    const InsertionCurve curve = insertion_into(liver(), seed);
    const Result<InsertionFit> fit = fit_insertion(std::vector{curve});
    ASSERT_TRUE(fit.ok()) << to_string(fit.error());
    const SurfaceSettings& surface = *fit->tissue.layers[0].surface;
    EXPECT_NEAR(surface.punctures_at_N, 1.4, 0.08) << "seed " << seed;
    EXPECT_NEAR(fit->punctured_at_m, 0.0118, 0.0015) << "60 d + 5000 d^2 = 1.4, from a contact that is felt at 50 mN";
    EXPECT_LT(*relative_error(*fit, curve), 0.06) << "seed " << seed;
    const Result<double> on_other = relative_error(*fit, insertion_into(liver(), seed + 10));
    EXPECT_LT(*on_other, 0.06) << "another needle in the same tissue, seed " << seed;
    TissueSettings harder = liver();
    harder.layers[1].bulk->cuts_at_N = 2.0;
    EXPECT_GT(*relative_error(*fit, insertion_into(harder, seed)), 0.1) << "a harder tissue is no match";
  }
}

TEST(InsertionFit, SeveralCurvesGiveOneTissueBetweenThem) {
  TissueSettings harder = liver();
  harder.layers[0].bulk->cuts_at_N = 0.8;
  const std::vector<InsertionCurve> both{insertion_into(liver(), 1), insertion_into(harder, 2)};
  const Result<InsertionFit> fit = fit_insertion(both);
  ASSERT_TRUE(fit.ok()) << to_string(fit.error());
  for (const InsertionCurve& one : both) EXPECT_LT(*relative_error(*fit, one), 0.15);
}

TEST(InsertionFit, RefusesWhatIsNoInsertion) {
  const auto refusal = [](const InsertionCurve& curve) {
    const Result<InsertionFit> fit = fit_insertion(std::vector{curve});
    return fit ? "fitted" : fit.error().what;
  };
  InsertionCurve curve = insertion_into(liver(), 1);
  EXPECT_EQ(refusal({}), "the curve has fewer than 40 samples");
  curve.force_N[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(curve), "sample 7 is not a number");
  curve.force_N[7] = 0.0;
  std::swap(curve.depth_m[100], curve.depth_m[200]);
  EXPECT_EQ(refusal(curve), "the depth falls at sample 101");
  InsertionCurve air = insertion_into(liver(), 1);
  for (double& force_N : air.force_N) force_N = 0.0;
  EXPECT_EQ(refusal(air), "less than 30 mm lie behind the contact");
  EXPECT_EQ(fit_insertion({}).error().what, "there is no curve");
}

/// All cuts into at most three pieces, one by one.
TEST(RisingPieces, AreTheBestOfAllCuts) {
  constexpr std::uint64_t kSeed = 3;
  device::Random random(kSeed);
  for (int round = 0; round < 20; ++round) {
    std::vector<double> samples;
    for (int i = 0; i < 14; ++i) samples.push_back(random.uniform(0.0, 1.0));
    const RisingPieces all(samples, 0.5, 3, 2);
    double least = 1e9;
    for (std::size_t a = 2; a <= 14; ++a)
      for (std::size_t b = a; b <= 14; ++b) {
        if ((a < 14 && a > 12) || (b < 14 && (b - a < 2 || b > 12))) continue;
        double sum = 0.0;
        const std::size_t ends[]{0, a, b, 14};
        for (int k = 0; k < 3; ++k)
          if (ends[k] < ends[k + 1])
            sum += RisingPieces(std::span(samples).subspan(ends[k], ends[k + 1] - ends[k]), 0.5, 1, 2).squares_from(0);
        least = std::min(least, sum);
      }
    EXPECT_NEAR(all.squares_from(0), least, 1e-9) << "seed " << kSeed;
    double own = 0.0;
    const std::vector<std::size_t> begins = all.begins_from(0);
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : samples.size();
      own += RisingPieces(std::span(samples).subspan(begins[k], end - begins[k]), 0.5, 1, 2).squares_from(0);
    }
    EXPECT_NEAR(own, least, 1e-9) << "the pieces are those of the sum";
  }
}

}  // namespace
}  // namespace telepalp::tissue
