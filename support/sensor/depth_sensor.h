#pragma once

#include <cstdint>
#include <vector>

#include "support/sensor/pixel_noise.h"

namespace telepalp::sensor {

/// The noise of a depth z, along the optical axis. It is independent between frames and between pixels.
enum class DepthNoise {
  None,
  Gaussian,  ///< sigma = gaussian_sigma_m everywhere
  Kinect,    ///< sigma = 1.2 mm + 1.9 mm (z - 0.4)^2, z in metres (Nguyen, Izadi, Lovell 2012, axial noise)
};

/// A simulated depth sensor. The default resembles a Kinect v1.
struct DepthSensorSettings {
  DepthNoise noise = DepthNoise::Kinect;
  double gaussian_sigma_m = 0.001;  ///< of DepthNoise::Gaussian
  bool disparity_steps = true;      ///< depth takes levels 2.85 mm z^2 apart (z in metres), as on a Kinect v1
  double unit_m = 0.001;            ///< metres per unit of a sample
  std::uint64_t seed = 1;
};

/// The noise of one frame. Pixels can be sampled in any order.
class Exposure {
 public:
  /// The random bits that determine the noise of `pixel`, an index in row-major order. The noise uses the lowest twelve
  /// bits only; a caller may use the highest eight for another purpose.
  [[nodiscard]] std::uint32_t bits(std::uint32_t pixel) const noexcept { return noise_.bits(pixel); }

  /// The sample, in units of `unit_m`, for a depth `z_m` > 0 with the noise of `bits`. It is 0 (no measurement) if the
  /// noisy depth is beyond 65535 units or, with disparity steps, nearer than the nearest level, 0.343 m.
  [[nodiscard]] std::uint16_t sample_of(float z_m, std::uint32_t bits) const noexcept {
    const float far_m = z_m - 0.4F;
    const float sigma_m = base_m_ + growth_per_m_ * far_m * far_m;
    const float seen_m = z_m + sigma_m * gaussian_[bits & (GaussianTable{}.size() - 1)];
    const float steps = levels_ != nullptr ? per_level_ / seen_m : seen_m * per_unit_;
    const float rounded = steps + 0.5F;
    const auto step = static_cast<std::uint32_t>(rounded >= 0.0F && rounded < beyond_ ? rounded : 0.0F);
    return levels_ != nullptr ? levels_[step] : static_cast<std::uint16_t>(step);
  }
  [[nodiscard]] std::uint16_t sample(float z_m, std::uint32_t pixel) const noexcept {
    return sample_of(z_m, bits(pixel));
  }

 private:
  friend class DepthSensor;
  explicit Exposure(const PixelNoise& noise) noexcept : noise_(noise) {}

  PixelNoise noise_;
  const float* gaussian_ = nullptr;
  float base_m_ = 0.0F;
  float growth_per_m_ = 0.0F;
  float per_unit_ = 0.0F;
  float per_level_ = 0.0F;
  const std::uint16_t* levels_ = nullptr;  ///< nullptr: the sensor has no disparity steps
  float beyond_ = 0.0F;                    ///< the first step, in units or levels, that a sample cannot hold
};

/// Models the error of a depth sensor: noise, then rounding to a disparity level or to a whole unit. A sample is a pure
/// function of settings, instant of the frame, pixel and true depth.
class DepthSensor {
 public:
  explicit DepthSensor(const DepthSensorSettings& settings);

  /// `instant` identifies the frame. The sensor must outlive the exposure.
  [[nodiscard]] Exposure expose(std::int64_t instant) const noexcept;
  [[nodiscard]] const DepthSensorSettings& settings() const noexcept { return settings_; }

 private:
  DepthSensorSettings settings_;
  std::vector<std::uint16_t> levels_;  ///< disparity level -> sample
};

}  // namespace telepalp::sensor
