#include "clients/mixed/device/device_model.h"

#include <numbers>

#include "proto/words/demand.h"

namespace telepalp::mixed {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d placed(const Vector3d& at_m, double about_x_rad = 0.0) {
  return Eigen::Translation3d(at_m) * AngleAxisd(about_x_rad, Vector3d::UnitX());
}

/// From the robot description's base (z up, the arm along y) to the haptic base's frame.
Isometry3d haptic_from_description() {
  return Isometry3d(AngleAxisd(std::numbers::pi, Vector3d::UnitY()) *
                    AngleAxisd(-std::numbers::pi / 2.0, Vector3d::UnitX()));
}

}  // namespace

DeviceModel omni() {
  DeviceModel model;
  model.joints = {
      {haptic_from_description() * placed({0.0, 0.0, 0.09}), Vector3d::UnitZ(), -0.98, 0.98},
      {placed({-0.0075, 0.0, 0.035}, 0.23), Vector3d::UnitX(), -0.24, 1.57},
      {placed({0.0075, 0.134, 0.0}, -2.15), Vector3d::UnitX(), -0.2, 1.95},
      {placed({0.0, 0.08, 0.0}), Vector3d::UnitY(), -2.54, 2.6},
      {placed({0.0, 0.0525, 0.0}, -0.85), Vector3d::UnitX(), -2.07, 0.23},
      {placed({0.0, -0.023, 0.0}), Vector3d::UnitY(), -2.34, 2.34},
  };
  model.prisms = {
      {0, {0.0, 0.045, 0.0}, {0.08, 0.045, 0.1}},         // base
      {1, {0.0, 0.0, 0.036}, {0.045, 0.045, 0.045}},      // torso
      {2, {0.0075, 0.067, 0.0}, {0.0175, 0.08, 0.0175}},  // upper arm
      {3, {0.0, 0.04, 0.0}, {0.011, 0.05, 0.011}},        // lower arm
      {4, {0.0, 0.02625, 0.0}, {0.0075, 0.034, 0.0075}},  // wrist
  };
  model.handle = {{0.0, -0.017, 0.0}, {0.0, 0.123, 0.0}, 0.003, 0.009};
  model.tip_m = {0.0, -0.017, 0.0};
  model.gimbal = 3;
  return model;
}

std::vector<Isometry3d> base_from_frames(const DeviceModel& model, std::span<const double> joints_rad) {
  demand(joints_rad.size() == model.joints.size(), "each joint of the device has an angle");
  std::vector<Isometry3d> frames{Isometry3d::Identity()};
  for (std::size_t i = 0; i < joints_rad.size(); ++i)
    frames.push_back(frames.back() * model.joints[i].parent_from_joint *
                     AngleAxisd(joints_rad[i], model.joints[i].axis));
  return frames;
}

Vector3d tip_of(const DeviceModel& model, std::span<const double> joints_rad) {
  return base_from_frames(model, joints_rad).back() * model.tip_m;
}

}  // namespace telepalp::mixed
