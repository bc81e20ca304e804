#pragma once

#include <memory>
#include <span>

#include "proto/words/frames.h"
#include "server/capture/synthetic/synthetic_patient.h"

namespace telepalp::bench::hand {

/// How the sensor sees.
enum class Sensor {
  Kinect,        ///< noise by depth, and disparity steps
  KinectSmooth,  ///< the same noise, without disparity steps, in samples of 0.1 mm
};

/// The shipped torso, 0.8 m below a camera that sees the middle 320 by 240 pixels: the same pixels as of a whole
/// image, at a quarter of the cost. Its own motion is `motion`; scripted poses ignore it. Made once and shared.
[[nodiscard]] std::shared_ptr<const server::SyntheticPatient> torso(Sensor sensor = Sensor::Kinect,
                                                                    server::Motion motion = server::Motion::Regular,
                                                                    std::uint64_t seed = 1);

/// A place on the skin to touch.
struct Spot {
  const char* name;
  double u;  ///< pixels from the image's middle
  double v;
};
[[nodiscard]] std::span<const Spot> spots() noexcept;

/// H with its origin on the skin at `spot` while the patient lies at rest; its y points up to the camera.
[[nodiscard]] Transform<HapticBase, DepthCamera> haptic_from_camera(const server::SyntheticPatient& patient,
                                                                    const Spot& spot);

/// The skin's unit normal at `spot`, at rest, in H.
[[nodiscard]] Vector<HapticBase> normal_at(const server::SyntheticPatient& patient, const Spot& spot);

}  // namespace telepalp::bench::hand
