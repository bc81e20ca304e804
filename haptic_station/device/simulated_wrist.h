#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace telepalp::device {

/// The wrist of a simulated hand that examines with an ultrasound probe. Each of its three angles swings about zero,
/// and an encoder reads it. At zero the palm looks straight down and the fingers point to the patient's head.
struct SimulatedWristSettings {
  struct Swing {
    double most_rad;
    double period_s;
  };
  Swing turn{0.35, 13.0};  ///< about the vertical
  Swing fan{0.26, 5.0};    ///< about the probe's long side: the image's plane sweeps through the body
  Swing rock{0.14, 8.0};   ///< in the image's plane
  double encoder_step_rad = 2.0 * std::numbers::pi / 4096.0;
};

/// Rotation from the hand's axes (tracking/hand_axes.h) to H as the encoders read it at simulation time `time_s`. Pure.
[[nodiscard]] inline Eigen::Quaterniond wrist_attitude(const SimulatedWristSettings& wrist, double time_s) noexcept {
  const auto encoded = [&](const SimulatedWristSettings::Swing& swing, const Eigen::Vector3d& axis) {
    const double angle = swing.most_rad * std::sin(2.0 * std::numbers::pi * time_s / swing.period_s);
    return Eigen::AngleAxisd(std::round(angle / wrist.encoder_step_rad) * wrist.encoder_step_rad, axis);
  };
  const Eigen::AngleAxisd palm_down(-0.5 * std::numbers::pi, Eigen::Vector3d::UnitX());
  return encoded(wrist.turn, Eigen::Vector3d::UnitY()) * encoded(wrist.fan, Eigen::Vector3d::UnitX()) *
         encoded(wrist.rock, Eigen::Vector3d::UnitZ()) * palm_down;
}

}  // namespace telepalp::device
