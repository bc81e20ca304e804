#pragma once

#include <optional>

#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/encountered_settings.h"

namespace telepalp::control {

/// The force of the phase Body to plane: "a force is applied to the end-effector in order to go farther from the body"
/// (paper S1, docs/sources.md). The force controls the velocity: a bounded rise that stops 2 mm above the plane, so
/// that an end-effector without a hand does not fly off while the phase waits for its dwell time.
///
/// The damper sees a smoothed velocity. One step of a coarse encoder appears as a velocity of 0.2 m/s for a tick, which
/// a damper of 15 N s/m would turn into 1 N. With the time constant b * step / 0.05 N, a step of 100 um changes the
/// force by 0.05 N in all. The smoothing acts outside the body alone.
///
/// A hand that comes down onto the end-effector leads it (hand_comes()): it meets at most
/// PositionControlSettings::against_hand_N. Owner: haptic thread.
class Lift {
 public:
  explicit Lift(const PositionControlSettings& settings) noexcept : settings_(settings) {}

  /// The force for the end-effector [N], `dt_s` after the last call. `target_height_m`: y of the plane in H.
  [[nodiscard]] Eigen::Vector3d step(const ControlInput& in, double target_height_m, double dt_s) noexcept;
  [[nodiscard]] const Eigen::Vector3d& force_N() const noexcept { return force_N_; }  ///< at the last step; or zero
  /// Call at a tick without lift: the next step() begins with the device's velocity and no force.
  void rest() noexcept {
    seen_m_per_s_.reset();
    force_N_.setZero();
  }

 private:
  PositionControlSettings settings_;
  std::optional<Eigen::Vector3d> seen_m_per_s_;  ///< the device's velocity, smoothed; nullopt: no lift
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();
};

}  // namespace telepalp::control
