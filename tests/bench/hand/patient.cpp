#include "tests/bench/hand/patient.h"

#include <map>
#include <mutex>
#include <tuple>

#include "support/program/files/shipped.h"

namespace telepalp::bench::hand {
namespace {

constexpr Spot kSpots[] = {{"belly", -40.0, 20.0}, {"flank", -30.0, 48.0}, {"chest", 75.0, -10.0}};

constexpr const char* kTorso = "deploy/demo_data/torso/visible_human_torso.ply";

Result<capture::TriangleMesh> read_torso() {
  const auto file = program::shipped_file(kTorso);
  if (!file)
    return Error{.what = "the synthetic torso is missing",
                 .where = kTorso,
                 .fix = "run telepalp-bench from its build folder, or set TELEPALP_HOME to the repository's folder"};
  return capture::read_mesh(*file);
}

/// Aborts if the torso is missing: the bench checks torso_is_there() first.
std::shared_ptr<const capture::SyntheticPatient> make(Sensor sensor, capture::Motion motion, std::uint64_t seed,
                                                      double camera_above_m) {
  const Result<capture::TriangleMesh> mesh = read_torso();
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
  if (const auto mesh = read_torso(); !mesh) return mesh.error();
  return {};
}

}  // namespace telepalp::bench::hand
