#pragma once

#include <cstdint>
#include <vector>

#include "server/capture/synthetic/shape/rest_shape.h"
#include "server/capture/synthetic/shape/settings.h"

namespace telepalp::server {

/// What the simulated sensor needs at each pixel, worked out once: depth moves by a multiplication, and whether a pixel
/// is measured is one comparison.
class SensorModel {
 public:
  SensorModel(const RestShape& rest, const SyntheticSettings& settings);

  /// The depth samples seen when the belly stands `lift_m` above full exhale. `instant` names the frame: the same
  /// instant and seed give the same noise. `out` has one value a pixel; 0 is "not measured".
  void measure(double lift_m, std::int64_t instant, std::vector<std::uint16_t>& out) const;

 private:
  SyntheticSettings settings_;
  std::vector<float> rest_depth_m_;
  std::vector<float> lift_share_;
  std::vector<std::uint8_t> hole_of_256_;    ///< a pixel is missing in this many of 256 frames; 255 means always
  std::vector<std::uint16_t> level_sample_;  ///< disparity level -> sample
};

/// Adds a sensor's brightness noise, at most 3 of 255, to a picture; the same `instant` and seed give the same noise.
void add_color_noise(std::vector<std::uint8_t>& rgb, std::int64_t instant, std::uint64_t seed);

}  // namespace telepalp::server
