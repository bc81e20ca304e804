#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "clients/mixed/calibration/device_fit.h"

namespace telepalp::mixed {

/// How a simulated gimbal's encoder errs over its range. Of these shapes the fit can represent the
/// whole sine alone.
enum class GimbalShape { WholeSine, Cubic, ShiftedSine };

/// A device whose encoders err, at a known place, clicked by a person whose hand errs. The truth is known.
class ClickedDevice {
 public:
  ClickedDevice(std::uint64_t seed, double gimbal_share, GimbalShape shape)
      : random_(seed), model_(omni()), shape_(shape) {
    Eigen::Vector3d axis(normal(), normal(), normal());
    world_from_haptic_.iso =
        Eigen::Translation3d(0.2, -0.1, 0.4) * Eigen::AngleAxisd(uniform(0.0, 3.0), axis.normalized());
    for (std::size_t i = 0; i < 2; ++i) {
      const Joint& joint = model_.joints[model_.gimbal + i];
      amplitude_rad_[i] = gimbal_share * (joint.most_rad - joint.least_rad) * uniform(-1.0, 1.0);
      phase_[i] = uniform(0.0, 2.0 * std::numbers::pi);
    }
  }

  [[nodiscard]] const DeviceModel& model() const { return model_; }
  [[nodiscard]] const Transform<World, HapticBase>& world_from_haptic() const { return world_from_haptic_; }

  /// The joints' true angles at these readings.
  [[nodiscard]] std::vector<double> angles_at(std::vector<double> readings_rad) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t j = model_.gimbal + i;
      const Joint& joint = model_.joints[j];
      const double t = (readings_rad[j] - joint.least_rad) / (joint.most_rad - joint.least_rad);
      readings_rad[j] += amplitude_rad_[i] * shape_at(t, phase_[i]);
    }
    return readings_rad;
  }

  /// Readings of the encoders with the tip at `haptic_m`, the first two gimbal joints near `yaw_share` and
  /// `pitch_share` of their ranges; empty if the arm does not reach it.
  [[nodiscard]] std::vector<double> reach(const Eigen::Vector3d& haptic_m, double yaw_share, double pitch_share) {
    for (int attempt = 0; attempt < 60; ++attempt) {
      std::vector<double> q(6);
      for (std::size_t j = 0; j < 6; ++j) q[j] = at_share(j, uniform(0.2, 0.8));
      q[3] = at_share(3, yaw_share + 0.04 * normal());
      q[4] = at_share(4, pitch_share + 0.04 * normal());
      for (int step = 0; step < 25 && (haptic_m - tip_of(model_, angles_at(q))).norm() > 1e-9; ++step)
        move(q, haptic_m);
      if ((haptic_m - tip_of(model_, angles_at(q))).norm() < 1e-8 && in_range(q)) return q;
    }
    return {};
  }

  /// `repeats` clicks at each of `places` (1 to 16) rings: the corners of a box of 16 x 7 x 12 cm, then points on its
  /// edges. The handle is tilted each time. The hand errs by kClickDeviation_m an axis.
  [[nodiscard]] std::vector<Click> clicks(int places, int repeats) {
    std::vector<Click> clicks;
    for (int place = 0; place < places; ++place) {
      const Eigen::Vector3d haptic_m = ring_at(place);
      for (int repeat = 0; repeat < repeats; ++repeat) {
        const int tilt = (place + repeat) % 5;
        const Eigen::Vector3d off = Eigen::Vector3d(normal(), normal(), normal()) * kClickDeviation_m;
        std::vector<double> readings =
            reach(haptic_m + off, tilt == 4 ? 0.5 : (tilt & 1 ? 0.8 : 0.2), tilt == 4 ? 0.5 : (tilt & 2 ? 0.85 : 0.15));
        while (readings.empty()) readings = reach(haptic_m + off, uniform(0.2, 0.8), uniform(0.15, 0.85));
        clicks.push_back({place, world_from_haptic_ * Point<HapticBase>{haptic_m}, readings});
      }
    }
    return clicks;
  }

  /// A place in the box that was not clicked, in an attitude that was not clicked.
  [[nodiscard]] std::vector<double> elsewhere() {
    std::vector<double> readings;
    while (readings.empty())
      readings =
          reach(kMiddle + 0.5 * kSides.cwiseProduct(Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))),
                uniform(0.2, 0.8), uniform(0.15, 0.85));
    return readings;
  }

 private:
  static inline const Eigen::Vector3d kMiddle{0.0, 0.08, 0.16};
  static inline const Eigen::Vector3d kSides{0.16, 0.07, 0.12};

  double uniform(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }
  double normal() { return std::normal_distribution<double>()(random_); }
  [[nodiscard]] double at_share(std::size_t joint, double share) const {
    return std::lerp(model_.joints[joint].least_rad, model_.joints[joint].most_rad, share);
  }
  [[nodiscard]] double shape_at(double t, double phase) const {
    const double turn = 2.0 * std::numbers::pi * t;
    if (shape_ == GimbalShape::WholeSine) return std::sin(turn);
    if (shape_ == GimbalShape::Cubic) return 20.78 * t * (1.0 - t) * (0.5 - t);
    return std::sin(turn + phase) - std::sin(phase);
  }
  static Eigen::Vector3d ring_at(int place) {
    const auto side = [&](int bit) { return place & bit ? 0.5 : -0.5; };
    if (place < 8) return kMiddle + kSides.cwiseProduct(Eigen::Vector3d(side(1), side(2), side(4)));
    if (place < 12) return kMiddle + kSides.cwiseProduct(Eigen::Vector3d(0.0, side(2), side(1)));
    return kMiddle + kSides.cwiseProduct(Eigen::Vector3d(side(1), side(2), 0.0));
  }
  void move(std::vector<double>& q, const Eigen::Vector3d& goal_m) const {
    const Eigen::Vector3d tip = tip_of(model_, angles_at(q));
    Eigen::Matrix3d jacobian;
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double> moved = q;
      moved[k] += 1e-6;
      jacobian.col(static_cast<Eigen::Index>(k)) = (tip_of(model_, angles_at(moved)) - tip) / 1e-6;
    }
    Eigen::Vector3d step = jacobian.inverse() * (goal_m - tip);
    if (!step.allFinite()) step.setConstant(0.1);
    if (step.norm() > 0.3) step *= 0.3 / step.norm();
    for (std::size_t k = 0; k < 3; ++k) q[k] += step[static_cast<Eigen::Index>(k)];
  }
  [[nodiscard]] bool in_range(const std::vector<double>& q) const {
    for (std::size_t j = 0; j < 3; ++j)
      if (q[j] < model_.joints[j].least_rad || q[j] > model_.joints[j].most_rad) return false;
    return true;
  }

  std::mt19937_64 random_;
  DeviceModel model_;
  GimbalShape shape_;
  Transform<World, HapticBase> world_from_haptic_;
  std::array<double, 2> amplitude_rad_{};
  std::array<double, 2> phase_{};
};

/// Root mean squares of a fit's errors at places that were not clicked.
struct ElsewhereError {
  double wrist_m = 0.0;  ///< the gimbal's centre, which no gimbal angle moves: the error of the pose alone
  double tip_m = 0.0;    ///< the tip, by the pose and the corrected gimbal angles
};

/// The error over `seeds` devices of one kind, each calibrated by clicks and then moved to `probes` other places. 1 m
/// if a fit fails.
[[nodiscard]] inline ElsewhereError elsewhere_error(int places, int repeats, double gimbal_share, GimbalShape shape,
                                                    GimbalFit how, int seeds, int probes = 10) {
  double wrist = 0.0, tip = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    ClickedDevice device(static_cast<std::uint64_t>(seed) * 7919U, gimbal_share, shape);
    const Result<DeviceFit> fit = fit_device(device.model(), device.clicks(places, repeats), how);
    if (!fit) return {1.0, 1.0};
    const Eigen::Isometry3d& truth = device.world_from_haptic().iso;
    const Eigen::Isometry3d& fitted = fit->world_from_haptic.iso;
    for (int i = 0; i < probes; ++i) {
      const std::vector<double> readings = device.elsewhere();
      const Eigen::Vector3d wrist_m = base_from_frames(device.model(), readings)[5].translation();
      const Eigen::Vector3d true_tip = tip_of(device.model(), device.angles_at(readings));
      const Eigen::Vector3d fitted_tip = tip_of(device.model(), corrected(device.model(), fit->gimbal, readings));
      wrist += (fitted * wrist_m - truth * wrist_m).squaredNorm();
      tip += (fitted * fitted_tip - truth * true_tip).squaredNorm();
    }
  }
  const double n = static_cast<double>(seeds) * probes;
  return {std::sqrt(wrist / n), std::sqrt(tip / n)};
}

}  // namespace telepalp::mixed
