#include "haptic_station/calibration/tissue_fit.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "haptic_station/effects/presets/tissue_presets.h"
#include "where.h"

namespace telepalp::calibration {
namespace {

constexpr double kHalfStrain_m = 0.015;  // half the height of the 30 mm specimen

class TissuePresets : public ::testing::TestWithParam<effects::TissuePreset> {};

TEST_P(TissuePresets, AreTheFitToTheirMeasuredCurve) {
  const effects::TissuePreset& preset = GetParam();
  const auto test =
      read_compression_test(TELEPALP_SOURCE_DIR "/tests/data/tissue/" + std::string(preset.material) + ".csv");
  ASSERT_TRUE(test.ok()) << to_string(test.error());
  std::vector<CompressionSample> half;
  for (const CompressionSample& sample : *test)
    if (sample.compression_m <= kHalfStrain_m) half.push_back(sample);
  const Result<TissueFit> fit = fit_tissue(under_hand(half, {}, {}));
  ASSERT_TRUE(fit.ok()) << to_string(fit.error());
  for (const double depth_m : {0.005, 0.01, 0.02, 0.03})
    EXPECT_NEAR(preset.law.stiffness_N_per_m(depth_m), fit->law.stiffness_N_per_m(depth_m),
                0.002 * fit->law.stiffness_N_per_m(depth_m));
  EXPECT_NEAR(fit->rms_error_share, preset.rms_error_share, 5e-4);
  EXPECT_LT(fit->rms_error_share, 0.025);
}
INSTANTIATE_TEST_SUITE_P(All, TissuePresets, ::testing::ValuesIn(effects::kTissuePresets),
                         [](const auto& preset) { return std::string(preset.param.name); });

TEST(TissueFit, FindsTheLawThatMadeTheSamples) {
  std::vector<CompressionSample> samples;
  for (int i = 0; i <= 30; ++i) {
    const double d = 0.001 * i;
    samples.push_back({d, d * (100.0 + d * (2000.0 + d * 50'000.0))});
  }
  const Result<TissueFit> fit = fit_tissue(samples);
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR(fit->law.constant_N_per_m, 100.0, 1e-3);
  EXPECT_NEAR(fit->law.slope_N_per_m2, 2000.0, 0.1);
  EXPECT_NEAR(fit->law.curve_N_per_m3, 50'000.0, 2.0);
}

TEST(TissueFit, RefusesInvalidCompressionTests) {
  EXPECT_FALSE(fit_tissue({}).ok());
  std::vector<CompressionSample> samples(10, {0.01, -1.0});
  EXPECT_FALSE(fit_tissue(samples).ok());
  samples.assign(10, {0.01, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_FALSE(fit_tissue(samples).ok());
  EXPECT_FALSE(read_compression_test("/nowhere.csv").ok());
}

TEST(TissueFit, ReadsBlankLinesAndDosLineEndsAndRefusesTextAfterTheNumbers) {
  const std::string file = ::testing::TempDir() + "rows.csv";
  const auto read = [&](const std::string& rows) {
    std::ofstream(file) << "compression_mm,load_N\n" << rows;
    return read_compression_test(file);
  };
  const auto good = read("1,2\r\n\n3,4\n");
  ASSERT_TRUE(good.ok());
  ASSERT_EQ(good->size(), 2u);
  EXPECT_DOUBLE_EQ(good->back().load_N, 4.0);
  const auto text = read("1,2\n1,2xyz\n");
  ASSERT_FALSE(text.ok());
  EXPECT_TRUE(text.error().where.ends_with("rows.csv:3")) << text.error().where;
  std::filesystem::remove(file);
}

TEST(TissueFit, RefusesACompressionTestThatIsTooLongInsteadOfReadingItsBeginning) {
  const std::string file = ::testing::TempDir() + "too_long.csv";
  {
    std::ofstream out(file);
    out << "compression_mm,load_N\n";
    for (int row = 0; row <= 1'000'000; ++row) out << "1,2\n";
  }
  const Result<std::vector<CompressionSample>> read = read_compression_test(file);
  std::filesystem::remove(file);
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().what.find("more than 1000000 rows"), std::string::npos);
}

}  // namespace
}  // namespace telepalp::calibration
