#pragma once

#include "haptic_station/control/parts/critically_damped.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/encountered_settings.h"

namespace telepalp::control {

/// Position control of the free end-effector in Out body: proportional-derivative control to S1 eq. (5)'s target, which
/// follows the hand's x and z on the waiting plane. Owner: control thread.
class PositionControl {
 public:
  /// `offset_fade_s`: time constant with which eq. (5)'s Delta p fades.
  PositionControl(const PositionControlSettings& settings, double offset_fade_s) noexcept
      : settings_(settings), offset_fade_s_(offset_fade_s) {}

  /// Out body begins. The target starts with the position and velocity of the end-effector, so that the control begins
  /// at zero force.
  void begin(const ControlInput& in, double target_height_m) noexcept;

  /// The force for the end-effector [N]. `target_height_m`: height of the waiting plane.
  [[nodiscard]] Eigen::Vector3d step(const ControlInput& in, double target_height_m, double dt_s) noexcept;

  [[nodiscard]] const Point<HapticBase>& target() const noexcept { return target_; }  ///< S1's p_t at the last step

 private:
  void follow_hand(const ControlInput& in, double dt_s) noexcept;

  PositionControlSettings settings_;
  double offset_fade_s_;
  Moving hand_;    ///< the hand, smoothed over the tracker's updates
  Moving offset_;  ///< Delta p of S1 eq. (5), fading
  Point<HapticBase> target_;
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();
};

/// The force of Body to plane [N]: "a force is applied to the end-effector in order to go farther from the body" (S1).
/// It brings the end-effector to a bounded speed, so that an end-effector without a hand neither flies off nor rises
/// past the plane while the dwell lasts.
[[nodiscard]] Eigen::Vector3d lift_force_N(const ControlInput& in, double target_height_m,
                                           const PositionControlSettings& settings) noexcept;

}  // namespace telepalp::control
