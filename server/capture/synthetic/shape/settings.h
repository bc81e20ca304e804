#pragma once

#include <cstdint>

#include "proto/words/rgbd_frame.h"
#include "server/capture/synthetic/motion/patient_motion.h"

namespace telepalp::server {

/// How the depth along a ray scatters from frame to frame and pixel to pixel; independent in both.
enum class DepthNoise {
  None,
  Gaussian,  ///< sigma = gaussian_sigma_m everywhere
  Kinect,    ///< sigma = 1.2 mm + 1.9 mm (z - 0.4)^2, z in metres (Nguyen, Izadi, Lovell 2012, axial noise)
};

/// Everything that the synthetic patient depends on, besides the mesh and the time.
struct SyntheticSettings {
  Intrinsics camera{640, 480, 525.0, 525.0, 319.5, 239.5};
  double camera_above_body_m = 0.8;  ///< from the pinhole down to the body's highest point, at full exhale
  Motion motion = Motion::Regular;
  double amplitude_m = 0.005;  ///< how far the belly rises from full exhale to full inhale, 0 to 0.05
  double rate_hz = 0.25;       ///< breaths a second, 0 to 2
  DepthNoise noise = DepthNoise::Kinect;
  double gaussian_sigma_m = 0.001;
  bool disparity_steps = true;  ///< depth comes in levels 2.85 mm z^2 apart, as from 11-bit disparity
  bool holes = true;            ///< projector shadow, ragged silhouettes and grazing skin are not measured
  double depth_unit_m = 0.001;  ///< for one step of a sample; 0.0001 makes rounding at most 0.05 mm
  std::uint64_t seed = 1;       ///< of the noise and of the motion
};

}  // namespace telepalp::server
