#include "haptic_station/surface/depth/sample_depths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "support/images/image_file.h"
#include "support/sensor/depth_sensor.h"
#include "where.h"

namespace telepalp::surface {
namespace {

constexpr double kStep_per_m = 0.00285;  // the simulated sensor's, in 1/z

/// A belly 0.15 m above a bed at `bed_m`.
DepthImage belly(double bed_m, const sensor::DepthSensorSettings& settings, std::int64_t frame = 1) {
  const sensor::DepthSensor sensor(settings);
  const sensor::Exposure exposure = sensor.expose(frame);
  DepthImage image{.width = 160, .height = 120, .unit_m = settings.unit_m, .samples = {}};
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const double x = (u - 80) / 40.0;
      const double y = (v - 60) / 40.0;
      image.samples.push_back(exposure.sample(static_cast<float>(bed_m - 0.15 * std::exp(-0.5 * (x * x + y * y))),
                                              static_cast<std::uint32_t>(image.samples.size())));
    }
  return image;
}

double level_near(double z_m) { return 1.0 / (kStep_per_m * std::round(1.0 / (kStep_per_m * z_m))); }

double worst_m(const DepthField& field, const std::function<double(double)>& truth) {
  double worst = 0.0;
  for (const float z_m : field.z_m)
    worst = std::max(worst, std::abs(static_cast<double>(z_m) - truth(static_cast<double>(z_m))));
  return worst;
}

TEST(DepthSensor, ADepthOutOfItsRangeIsNoMeasurement) {
  const auto sample = [](const sensor::DepthSensorSettings& settings, float z_m) {
    return sensor::DepthSensor(settings).expose(1).sample(z_m, 0);
  };
  const sensor::DepthSensorSettings in_mm{.noise = sensor::DepthNoise::None, .disparity_steps = false};
  EXPECT_EQ(sample(in_mm, 65.535F), 65535);
  for (const float z_m : {65.54F, 100.0F, 1e9F, 0.0004F}) EXPECT_EQ(sample(in_mm, z_m), 0) << z_m << " m";
  sensor::DepthSensorSettings in_tenths = in_mm;
  in_tenths.unit_m = 0.0001;
  EXPECT_EQ(sample(in_tenths, 6.5F), 65000);
  EXPECT_EQ(sample(in_tenths, 6.6F), 0) << "65535 would be a depth";
  const sensor::DepthSensorSettings in_levels{.noise = sensor::DepthNoise::None};
  EXPECT_EQ(sample(in_levels, 0.344F), 344) << "level 1020 of 1023";
  for (const float z_m : {0.34F, 0.1F}) EXPECT_EQ(sample(in_levels, z_m), 0) << z_m << " m is nearer than any level";
}

TEST(SampleDepths, DepthsOfADisparitySensorAreReplacedByItsLevelsFromTheFirstImageOn) {
  for (const double bed_m : {0.85, 1.2}) {
    SampleDepths samples;
    const DepthImage image = belly(bed_m, {});
    const DepthField field = samples.field_of(image);
    ASSERT_TRUE(samples.levels()) << "bed at " << bed_m << " m";
    EXPECT_LT(worst_m(field, level_near), 3e-5) << "bed at " << bed_m << " m";
    EXPECT_GT(worst_m(to_depth_field(image), level_near), 4e-4) << "the rounding, which would remain";
  }
}

TEST(SampleDepths, ASensorWithoutStepsIsLeftAlone) {
  for (const double unit_m : {0.001, 0.0001})
    for (const auto noise : {sensor::DepthNoise::Kinect, sensor::DepthNoise::None}) {
      SampleDepths samples;
      for (int frame = 0; frame < 40; ++frame) {
        const DepthImage image = belly(0.85, {.noise = noise, .disparity_steps = false, .unit_m = unit_m}, frame);
        ASSERT_EQ(samples.field_of(image).z_m, to_depth_field(image).z_m) << "unit " << unit_m << " m, frame " << frame;
      }
    }
}

/// Where levels lie closer than a unit, each value has a level, and noise averages the rounding away.
TEST(SampleDepths, ANearPatientIsLeftAloneBecauseEachValueIsALevel) {
  SampleDepths samples;
  const DepthImage image = belly(0.55, {});
  EXPECT_EQ(samples.field_of(image).z_m, to_depth_field(image).z_m);
}

TEST(SampleDepths, AnotherCameraIsNoticed) {
  SampleDepths samples;
  (void)samples.field_of(belly(0.85, {}));
  ASSERT_TRUE(samples.levels());
  const DepthImage smooth = belly(0.85, {.disparity_steps = false});
  for (int image = 0; image < 32; ++image) (void)samples.field_of(smooth);
  EXPECT_EQ(samples.field_of(smooth).z_m, to_depth_field(smooth).z_m);
  const DepthImage finer = belly(0.85, {.disparity_steps = false, .unit_m = 0.0005});
  EXPECT_EQ(samples.field_of(finer).z_m, to_depth_field(finer).z_m);
}

TEST(SampleDepths, BlackImagesNeitherShowLevelsNorTakeThemAway) {
  SampleDepths samples;
  DepthImage black = belly(0.85, {});
  for (std::uint16_t& sample : black.samples) sample = 0;
  for (int image = 0; image < 31; ++image) (void)samples.field_of(black);
  EXPECT_FALSE(samples.levels());
  (void)samples.field_of(black);
  (void)samples.field_of(black);
  for (int image = 0; image < 32; ++image) (void)samples.field_of(belly(0.85, {}));
  ASSERT_TRUE(samples.levels()) << "a camera that starts black is checked again";
  for (int image = 0; image < 33; ++image) (void)samples.field_of(black);
  EXPECT_TRUE(samples.levels());
}

/// The bound that makes a wrong guess harmless.
TEST(SampleDepths, NoDepthMovesByMoreThanItsRounding) {
  SampleDepths samples;
  const DepthImage image = belly(0.85, {});
  (void)samples.field_of(image);
  ASSERT_TRUE(samples.levels());
  for (int sample = 1; sample < 65536; ++sample)
    ASSERT_LE(std::abs(samples.levels()->depth_of(sample) - sample), DisparityLevels::kMostMiss) << sample;
}

struct Recorded {
  const char* file;
  double unit_m;
  double step_per_m;  ///< 0: no levels
};

/// Kinect v1 and RealSense D4xx (1/32 of a pixel of disparity) measure disparity; RealSense SR305 does not.
TEST(SampleDepths, RecordedCamerasShowTheirLevels) {
  for (const auto& [file, unit_m, step_per_m] :
       {Recorded{"images_tiff_pairs/frame_20121214T142255.814212_depth.tiff", 0.001, 0.002925},
        Recorded{"images_tiff_pairs/frame_20121214T142256.068683_depth.tiff", 0.001, 0.002925},
        Recorded{"images_rgb_depth/depth/40.png", 0.001, 0.001633},
        Recorded{"images_rgb_depth/depth/41.png", 0.001, 0.001633}, Recorded{"images_depth_only/30.png", 0.000125, 0.0},
        Recorded{"images_depth_only/70.png", 0.000125, 0.0}}) {
    const auto read = images::read_depth_image(std::string(TELEPALP_SOURCE_DIR "/tests/data/") + file);
    ASSERT_TRUE(read) << file;
    const auto levels = disparity_levels_of(
        counts_of({.width = read->width, .height = read->height, .unit_m = unit_m, .samples = read->samples}), unit_m);
    ASSERT_EQ(levels.has_value(), step_per_m > 0.0) << file;
    if (levels) {
      EXPECT_NEAR(levels->step_per_unit / unit_m, step_per_m, 1e-6) << file;
    }
  }
}

}  // namespace
}  // namespace telepalp::surface
