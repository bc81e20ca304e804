#pragma once

#include <cstdint>

#include "proto/words/rgbd_frame.h"
#include "server/capture/synthetic/motion/patient_motion.h"
#include "support/sensor/depth_sensor.h"

namespace telepalp::capture {

using sensor::DepthNoise;

/// Settings of the synthetic patient.
struct SyntheticSettings {
  Intrinsics camera{640, 480, 525.0, 525.0, 319.5, 239.5};
  double camera_above_body_m = 0.8;  ///< from the pinhole down to the body's highest point, at full exhale
  Motion motion = Motion::Regular;
  double amplitude_m = 0.005;  ///< rise of the belly from full exhale to full inhale, 0 to 0.05
  double rate_hz = 0.25;       ///< breaths per second, 0 to 2
  DepthNoise noise = DepthNoise::Kinect;
  double gaussian_sigma_m = 0.001;  ///< standard deviation of DepthNoise::Gaussian
  bool disparity_steps = true;      ///< depth takes steps of 2.85 mm z^2 (z in metres), like 11-bit disparity
  bool holes = true;                ///< projector shadow, ragged silhouettes and grazing skin are not measured
  double depth_unit_m = 0.001;      ///< metres per unit of a sample; with 0.0001, the rounding error is at most 0.05 mm
  bool colleague = false;           ///< every 24 s, a colleague's hand comes over the belly, stays for 10 s, and leaves
  std::uint64_t seed = 1;           ///< seed of the noise and of the motion
};

}  // namespace telepalp::capture
