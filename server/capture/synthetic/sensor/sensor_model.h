#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "server/capture/synthetic/motion/patient_pose.h"
#include "server/capture/synthetic/shape/rest_shape.h"
#include "server/capture/synthetic/shape/settings.h"

namespace telepalp::server {

/// What the simulated sensor needs at each pixel, worked out once: depth moves by a multiplication, and whether a pixel
/// is measured is one comparison.
class SensorModel {
 public:
  /// `rest` is shared with the patient's TrueSurface: both see the same immutable shape.
  SensorModel(std::shared_ptr<const RestShape> rest, const SyntheticSettings& settings);

  /// The depth samples seen of a patient in `pose`. `instant` names the frame: the same instant and seed give the same
  /// noise. `out` has one value a pixel; 0 is "not measured".
  void measure(const PatientPose& pose, std::int64_t instant, std::vector<std::uint16_t>& out) const;

 private:
  /// What measure() reads at each pixel, where the body has slid or risen.
  struct Moved {
    std::vector<float> depth_m;  ///< without the breath
    std::vector<float> lift_share;
    std::vector<std::uint8_t> hole_of_256;
  };
  [[nodiscard]] Moved moved_to(const PatientPose& pose) const;

  std::shared_ptr<const RestShape> rest_;
  SyntheticSettings settings_;
  std::vector<float> rest_depth_m_;
  std::vector<float> lift_share_;
  std::vector<std::uint8_t> hole_of_256_;    ///< a pixel is missing in this many of 256 frames; 255 means always
  std::vector<std::uint16_t> level_sample_;  ///< disparity level -> sample
};

/// Adds a sensor's brightness noise, at most 3 of 255, to a picture; the same `instant` and seed give the same noise.
void add_color_noise(std::vector<std::uint8_t>& rgb, std::int64_t instant, std::uint64_t seed);

}  // namespace telepalp::server
