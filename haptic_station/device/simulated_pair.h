#pragma once

#include "proto/words/frames.h"

namespace telepalp::device {

/// A simulated three-axis haptic device like that of paper S1 (docs/sources.md), with friction and gravity compensated.
struct SimulatedDeviceSettings {
  double mass_kg = 0.3;
  double damping_N_s_per_m = 1.0;
  double encoder_step_m = 0.13e-6;  ///< resolution of the reported position (S1 II.A)
  double peak_N = 10.0;             ///< largest force of the motors
};

/// A person's arm and hand: a mass that a spring and a damper pull towards the intended position. It yields to force.
/// It can push the end-effector but not pull it.
struct SimulatedHandSettings {
  double mass_kg = 0.5;
  double stiffness_N_per_m = 300.0;
  double damping_N_s_per_m = 20.0;
  double pad_stiffness_N_per_m = 3000.0;  ///< stiffness of the fingertips against the end-effector
  double pad_damping_N_s_per_m = 8.0;
  double friction = 0.8;  ///< friction coefficient between fingertips and end-effector
  double reach_m = 0.05;  ///< beyond this horizontal distance the hand misses the end-effector
};

/// The position that the person aims at, and its velocity.
struct Intention {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
};

/// A simulated device held by a simulated hand. The two masses and all springs between them are stepped together by
/// a linearly implicit scheme: stable at 2 kHz for every stiffness. Pure. Owner: haptic thread.
class SimulatedPair {
 public:
  SimulatedPair(const SimulatedDeviceSettings& device, const SimulatedHandSettings& hand) noexcept
      : device_settings_(device), hand_settings_(hand) {}

  /// Places device and hand, both at rest.
  void place(const Point<HapticBase>& device, const Point<HapticBase>& hand) noexcept;

  /// Advances by `dt_s` with the motor force `motors` while the person aims at `intention`. A motor force that is not
  /// finite counts as zero, as in a real amplifier.
  void step(const Force<HapticBase>& motors, const Intention& intention, double dt_s) noexcept;

  /// Position as the device's encoders report it.
  [[nodiscard]] Point<HapticBase> device() const noexcept;
  [[nodiscard]] Vector<HapticBase> device_velocity() const noexcept { return reported_velocity_; }

  /// True states, without quantisation and filter.
  [[nodiscard]] const Point<HapticBase>& true_device() const noexcept { return device_; }
  [[nodiscard]] const Vector<HapticBase>& true_device_velocity() const noexcept { return device_velocity_; }
  [[nodiscard]] const Point<HapticBase>& true_hand() const noexcept { return hand_; }
  [[nodiscard]] const Vector<HapticBase>& true_hand_velocity() const noexcept { return hand_velocity_; }
  /// Force of the end-effector on the hand; zero when they do not touch.
  [[nodiscard]] const Force<HapticBase>& felt() const noexcept { return felt_; }
  [[nodiscard]] bool saturated() const noexcept { return saturated_; }

 private:
  SimulatedDeviceSettings device_settings_;
  SimulatedHandSettings hand_settings_;
  Point<HapticBase> device_;
  Vector<HapticBase> device_velocity_;
  Vector<HapticBase> reported_velocity_;
  Point<HapticBase> reported_;
  Point<HapticBase> hand_;
  Vector<HapticBase> hand_velocity_;
  Force<HapticBase> felt_;
  bool touching_ = false;
  bool was_above_ = true;  ///< at the last step the hand was at or above the end-effector's height
  bool saturated_ = false;
  Eigen::Vector3d grip_m_ = Eigen::Vector3d::Zero();  ///< hand minus device at zero tangential force; x and z count
};

}  // namespace telepalp::device
