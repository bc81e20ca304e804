#include "tests/bench/hand/patient.h"

#include <map>
#include <mutex>
#include <tuple>

#include "server/capture/synthetic/source/patient_model.h"

namespace telepalp::bench::hand {
namespace {

constexpr Spot kSpots[] = {{"belly", -40.0, 20.0}, {"flank", -30.0, 48.0}, {"chest", 75.0, -10.0}};

/// Aborts if the torso is missing: the bench checks torso_is_there() first.
std::shared_ptr<const capture::SyntheticPatient> make(Sensor sensor, capture::Motion motion, std::uint64_t seed,
                                                      double camera_above_m) {
  const Result<capture::TriangleMesh> mesh = capture::shipped_torso();
  capture::SyntheticSettings settings;
  settings.camera = {.width = 320, .height = 240, .fx = 525.0, .fy = 525.0, .cx = 159.5, .cy = 119.5};
  settings.camera_above_body_m = camera_above_m;
  settings.motion = motion;
  settings.seed = seed;
  if (sensor == Sensor::KinectSmooth) {
    settings.disparity_steps = false;
    settings.depth_unit_m = 0.0001;
  }
  return std::make_shared<const capture::SyntheticPatient>(*capture::SyntheticPatient::make(*mesh, settings));
}

}  // namespace

std::shared_ptr<const capture::SyntheticPatient> torso(Sensor sensor, capture::Motion motion, std::uint64_t seed,
                                                       double camera_above_m) {
  static std::mutex mutex;
  static std::map<std::tuple<Sensor, capture::Motion, std::uint64_t, double>,
                  std::shared_ptr<const capture::SyntheticPatient>>
      made;
  const std::lock_guard lock(mutex);
  auto& patient = made[{sensor, motion, seed, camera_above_m}];
  if (!patient) patient = make(sensor, motion, seed, camera_above_m);
  return patient;
}

std::shared_ptr<const capture::SyntheticPatient> torso(Sensor sensor, capture::Motion motion, std::uint64_t seed) {
  return torso(sensor, motion, seed, kCameraAbove_m);
}

std::span<const Spot> spots() noexcept { return kSpots; }

Transform<HapticBase, DepthCamera> haptic_from_camera(const capture::SyntheticPatient& patient, const Spot& spot) {
  const Intrinsics& camera = patient.settings().camera;
  const Eigen::Vector3d skin = patient.surface_of({}).at_pixel(camera.cx + spot.u, camera.cy + spot.v).at.m;
  Transform<HapticBase, DepthCamera> placed;
  placed.iso.linear() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  placed.iso.translation() = -placed.iso.linear() * skin;
  return placed;
}

Vector<HapticBase> normal_at(const capture::SyntheticPatient& patient, const Spot& spot) {
  const Intrinsics& camera = patient.settings().camera;
  return haptic_from_camera(patient, spot) *
         patient.surface_of({}).at_pixel(camera.cx + spot.u, camera.cy + spot.v).normal;
}

double rest_height_m(const capture::SyntheticPatient& patient, capture::PatientPose pose,
                     const Transform<HapticBase, DepthCamera>& haptic_from_camera) {
  if (!pose.slides() && !pose.rises()) return 0.0;
  pose.breath = {};
  const Transform<DepthCamera, HapticBase> camera_from_haptic = haptic_from_camera.inverse();
  const auto height = patient.surface_of(pose).height_along(
      camera_from_haptic * Point<HapticBase>{}, camera_from_haptic * Vector<HapticBase>{Eigen::Vector3d::UnitY()});
  return height ? height->m : 0.0;
}

Result<void> torso_is_there() {
  if (const auto mesh = capture::shipped_torso(); !mesh) return mesh.error();
  return {};
}

}  // namespace telepalp::bench::hand
