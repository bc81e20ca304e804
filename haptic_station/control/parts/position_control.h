#pragma once

#include "haptic_station/control/parts/critically_damped.h"
#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/encountered_settings.h"

namespace telepalp::control {

/// Position control of the free end-effector in the phase Out body: proportional-derivative control to the target of
/// eq. (5) of paper S1 (docs/sources.md). The target follows the hand's x and z at the height of the waiting plane, in
/// H, the haptic base's frame, with y up.
///
/// The force changes at a limited rate, so that neither a coarse encoder nor a jump of the hand is felt as a step. A
/// rate limit delays the force of a fast movement. A stiff control would then swing for ever with its whole force: with
/// 400 N/m, 25 N s/m and 56 N/s, a free device of 0.3 kg swings at 4.5 Hz by 22 mm. With the settings' stiffness and
/// damping every free device of 0.1 to 1 kg and 0.3 to 3 N s/m comes to rest, also when its force comes 4 ms late.
///
/// A hand that comes down onto the end-effector (hand_comes()) meets an upward force of at most
/// PositionControlSettings::against_hand_N, although Out body lasts until its dwell ends. Owner: haptic thread.
class PositionControl {
 public:
  /// `offset_fade_s`: decay time constant of Delta p in eq. (5). When Out body begins, Delta p is the position of the
  /// end-effector minus the point with the hand's x and z and the target's height.
  PositionControl(const PositionControlSettings& settings, double offset_fade_s) noexcept
      : settings_(settings), offset_fade_s_(offset_fade_s) {}

  /// Call when Out body begins. The target starts with the position and velocity of the end-effector. The force starts
  /// with `from_N`, the lift's: if the lift's force faded while this one began at zero and grew, their sum would exceed
  /// the bound of each on a hand that comes down.
  void begin(const ControlInput& in, double target_height_m, const Eigen::Vector3d& from_N) noexcept;

  /// The force for the end-effector [N]. `target_height_m`: y of the target in H.
  [[nodiscard]] Eigen::Vector3d step(const ControlInput& in, double target_height_m, double dt_s) noexcept;

  [[nodiscard]] const Point<HapticBase>& target() const noexcept { return target_; }  ///< S1's p_t at the last step

 private:
  void follow_hand(const ControlInput& in, double dt_s) noexcept;
  void follow_height(double target_height_m, double dt_s) noexcept;

  PositionControlSettings settings_;
  double offset_fade_s_;
  Moving hand_;                 ///< the tracked hand after a low-pass filter that smooths the tracker's 100 Hz steps
  double height_m_ = 0.0;       ///< height of the target at the last step
  double rises_m_per_s_ = 0.0;  ///< smoothed vertical speed of the target
  Moving offset_;               ///< Delta p of S1 eq. (5), which decays to zero
  Point<HapticBase> target_;
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();
};

}  // namespace telepalp::control
