#pragma once

#include "proto/words/frames.h"

namespace telepalp::device {

/// A three-axis haptic device of S1's class (its workspace, friction and gravity are compensated).
struct SimulatedDeviceSettings {
  double mass_kg = 0.3;
  double damping_N_s_per_m = 1.0;
  double encoder_step_m = 0.13e-6;    ///< S1 II.A
  double peak_N = 10.0;               ///< the motors give no more
  double velocity_filter_hz = 150.0;  ///< of the velocity that the device reports
};

/// A person's arm and hand: a mass that a spring and a damper pull towards where the person wants it. It yields to
/// force, and it can only push the end-effector, never pull it.
struct SimulatedHandSettings {
  double mass_kg = 0.5;
  double stiffness_N_per_m = 300.0;
  double damping_N_s_per_m = 20.0;
  double pad_stiffness_N_per_m = 3000.0;  ///< of the fingers' flesh on the end-effector
  double pad_damping_N_s_per_m = 8.0;
  double friction = 0.8;  ///< of the flesh on the end-effector
  double reach_m = 0.05;  ///< further off the end-effector's axis than this, the hand misses it
};

/// Where the person wants the hand, and how fast that moves.
struct Intention {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
};

/// A simulated device held by a simulated hand. The two masses and all springs between them are stepped together by
/// a linearly implicit scheme: stable at 2 kHz for every stiffness. Pure. Owner: control thread.
class SimulatedPair {
 public:
  SimulatedPair(const SimulatedDeviceSettings& device, const SimulatedHandSettings& hand) noexcept
      : device_settings_(device), hand_settings_(hand) {}

  /// Puts both at rest.
  void place(const Point<HapticBase>& device, const Point<HapticBase>& hand) noexcept;

  /// The motors give `motors` for `dt_s`, while the person aims at `intention`. Forces that are not finite count as
  /// none, as a real amplifier's input stage does.
  void step(const Force<HapticBase>& motors, const Intention& intention, double dt_s) noexcept;

  /// As the device's encoders say.
  [[nodiscard]] Point<HapticBase> device() const noexcept;
  [[nodiscard]] Vector<HapticBase> device_velocity() const noexcept { return reported_velocity_; }

  /// The truth, which no sensor sees.
  [[nodiscard]] const Point<HapticBase>& true_device() const noexcept { return device_; }
  [[nodiscard]] const Vector<HapticBase>& true_device_velocity() const noexcept { return device_velocity_; }
  [[nodiscard]] const Point<HapticBase>& true_hand() const noexcept { return hand_; }
  [[nodiscard]] const Vector<HapticBase>& true_hand_velocity() const noexcept { return hand_velocity_; }
  /// What the end-effector does to the hand; zero when they do not touch.
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
  bool was_above_ = true;  ///< the hand was over the end-effector, or level with it, a step ago
  bool saturated_ = false;
  Eigen::Vector3d grip_m_ = Eigen::Vector3d::Zero();  ///< hand less device where the flesh holds, tangential
};

}  // namespace telepalp::device
