#include "tests/bench/hand/patient.h"

#include <map>
#include <mutex>
#include <tuple>

#include "support/program/files/shipped.h"

namespace telepalp::bench::hand {
namespace {

constexpr Spot kSpots[] = {{"belly", -40.0, 20.0}, {"flank", -30.0, 48.0}, {"chest", 75.0, -10.0}};

/// Aborts if the torso is missing, because it is part of the source tree.
std::shared_ptr<const capture::SyntheticPatient> make(Sensor sensor, capture::Motion motion, std::uint64_t seed,
                                                      double camera_above_m) {
  const auto file = program::shipped_file("deploy/demo_data/torso/visible_human_torso.ply");
  const Result<capture::TriangleMesh> mesh = capture::read_mesh(file.value());
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

}  // namespace telepalp::bench::hand
