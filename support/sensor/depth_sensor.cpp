#include "support/sensor/depth_sensor.h"

#include <cmath>

namespace telepalp::sensor {
namespace {

constexpr double kLevelSpacing_per_m = 0.00285;  // dz = 2.85 mm z^2, z in metres, as measured on Kinect v1 frames
constexpr std::size_t kLevels = 1024;
constexpr float kAxialNoise_m = 0.0012F;
constexpr float kAxialNoiseGrowth_per_m = 0.0019F;

std::uint16_t sample_of(double depth_m, double unit_m) {
  const double steps = std::round(depth_m / unit_m);
  return steps >= 1.0 && steps <= 65535.0 ? static_cast<std::uint16_t>(steps) : std::uint16_t{0};
}

}  // namespace

DepthSensor::DepthSensor(const DepthSensorSettings& settings) : settings_(settings) {
  if (!settings.disparity_steps) return;
  levels_.resize(kLevels, 0);
  for (std::size_t level = 1; level < kLevels; ++level)
    levels_[level] = sample_of(1.0 / (kLevelSpacing_per_m * static_cast<double>(level)), settings.unit_m);
}

Exposure DepthSensor::expose(std::int64_t instant) const noexcept {
  Exposure exposure{PixelNoise{settings_.seed, instant}};
  exposure.gaussian_ = gaussian_table().data();
  if (settings_.noise == DepthNoise::Gaussian) exposure.base_m_ = static_cast<float>(settings_.gaussian_sigma_m);
  if (settings_.noise == DepthNoise::Kinect) {
    exposure.base_m_ = kAxialNoise_m;
    exposure.growth_per_m_ = kAxialNoiseGrowth_per_m;
  }
  exposure.per_unit_ = static_cast<float>(1.0 / settings_.unit_m);
  exposure.per_level_ = static_cast<float>(1.0 / kLevelSpacing_per_m);
  exposure.beyond_ = 65536.0F;
  if (settings_.disparity_steps) {
    exposure.levels_ = levels_.data();
    exposure.beyond_ = static_cast<float>(levels_.size());
  }
  return exposure;
}

}  // namespace telepalp::sensor
