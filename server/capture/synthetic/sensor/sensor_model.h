#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "server/capture/synthetic/motion/patient_pose.h"
#include "server/capture/synthetic/shape/rest_shape.h"
#include "server/capture/synthetic/shape/settings.h"
#include "support/sensor/depth_sensor.h"

namespace telepalp::capture {

/// Simulates the depth sensor. The per-pixel tables of the body at rest are computed once; measure() computes new
/// tables for each frame of a body that has slid or risen.
class SensorModel {
 public:
  /// `rest` is shared with the patient's TrueSurface, so that both use one immutable shape.
  SensorModel(std::shared_ptr<const RestShape> rest, const SyntheticSettings& settings);

  /// Measures a patient in `pose`. `instant`, such as the session time [ns], and the seed select the noise. `out`: the
  /// depth of each pixel in units of the settings' depth_unit_m, row by row; 0 means "not measured".
  void measure(const PatientPose& pose, std::int64_t instant, std::vector<std::uint16_t>& out) const;

 private:
  /// Per-pixel tables for a body that has slid or risen.
  struct Moved {
    std::vector<float> depth_m;     ///< depth without the breath
    std::vector<float> lift_share;  ///< RestShape::lift_share()
    std::vector<std::uint8_t> hole_of_256;
  };
  [[nodiscard]] Moved moved_to(const PatientPose& pose) const;
  [[nodiscard]] Moved with_hand(const PatientPose& pose) const;

  std::shared_ptr<const RestShape> rest_;
  bool holes_;
  sensor::DepthSensor sensor_;
  std::vector<float> rest_depth_m_;
  std::vector<float> lift_share_;
  std::vector<std::uint8_t> hole_of_256_;  ///< a pixel is missing in this many of 256 frames; 255 means always
};

/// Adds brightness noise of at most 3 of 255 to a colour image; equal `instant` and `seed` give equal noise.
void add_color_noise(std::vector<std::uint8_t>& rgb, std::int64_t instant, std::uint64_t seed);

}  // namespace telepalp::capture
