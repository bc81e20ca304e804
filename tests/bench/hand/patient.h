#pragma once

#include <memory>
#include <span>

#include "proto/words/frames.h"
#include "proto/words/result.h"
#include "server/capture/synthetic/synthetic_patient.h"

namespace telepalp::bench::hand {

/// The kinds of simulated sensor.
enum class Sensor {
  Kinect,        ///< noise that grows with depth, and disparity steps
  KinectSmooth,  ///< the same noise, without disparity steps, in samples of 0.1 mm
};

inline constexpr double kCameraAbove_m = 0.8;

/// The torso of the repository, `camera_above_m` below a camera. The camera has the middle 320 by 240 pixels of a full
/// image, which costs a quarter of the time. `motion`: the torso's motion; scripted poses ignore it. Each torso is made
/// once and shared.
[[nodiscard]] std::shared_ptr<const capture::SyntheticPatient> torso(Sensor sensor, capture::Motion motion,
                                                                     std::uint64_t seed, double camera_above_m);
/// The torso kCameraAbove_m below the camera.
[[nodiscard]] std::shared_ptr<const capture::SyntheticPatient> torso(Sensor sensor = Sensor::Kinect,
                                                                     capture::Motion motion = capture::Motion::Regular,
                                                                     std::uint64_t seed = 1);

/// A place on the skin to touch, as seen from kCameraAbove_m.
struct Spot {
  const char* name;
  double u;  ///< pixels from the image's middle
  double v;
};
[[nodiscard]] std::span<const Spot> spots() noexcept;

/// The transform of a frame H with its origin on the skin at `spot` of the patient at rest; y points to the camera.
[[nodiscard]] Transform<HapticBase, DepthCamera> haptic_from_camera(const capture::SyntheticPatient& patient,
                                                                    const Spot& spot);

/// The skin's unit normal at `spot`, at rest, in H.
[[nodiscard]] Vector<HapticBase> normal_at(const capture::SyntheticPatient& patient, const Spot& spot);

/// The skin's height in H above the origin, without the breath [m]. A hand rides at this height when it follows a
/// patient who shifts or sits up. 0: the patient does neither.
[[nodiscard]] double rest_height_m(const capture::SyntheticPatient& patient, capture::PatientPose pose,
                                   const Transform<HapticBase, DepthCamera>& haptic_from_camera);

/// Error: the torso's file cannot be found or read.
[[nodiscard]] Result<void> torso_is_there();

}  // namespace telepalp::bench::hand
