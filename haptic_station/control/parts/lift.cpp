#include "haptic_station/control/parts/lift.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/control/parts/coming_hand.h"
#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {

Eigen::Vector3d Lift::step(const ControlInput& in, double target_height_m, double dt_s) noexcept {
  constexpr double kBrakes_s = 0.05;
  constexpr double kSlew_N_per_s = 50.0;  // 0.025 N per tick; meanwhile the last phase's force fades by 0.02 N per tick
  constexpr double kBeyond_m = 0.002;     // the lift aims above the plane, so that it reaches the plane
  constexpr double kCoarsestEncoder_m = 100e-6;
  constexpr double kEncoderStep_N = 0.05;  // the change of force that one step of this encoder may cause
  const double smooths_s = settings_.lift_damping_N_s_per_m * kCoarsestEncoder_m / kEncoderStep_N;
  Eigen::Vector3d& seen = seen_m_per_s_ ? *seen_m_per_s_ : seen_m_per_s_.emplace(in.device_velocity.v);
  seen += (in.device_velocity.v - seen) * (dt_s / (smooths_s + dt_s));
  const double left_m = target_height_m + kBeyond_m - in.device.m.y();
  const double speed = std::clamp(left_m / kBrakes_s, -settings_.lift_speed_m_per_s, settings_.lift_speed_m_per_s);
  const double most_N = hand_comes(in) ? settings_.against_hand_N : settings_.lift_most_N;
  const Eigen::Vector3d wanted_N =
      at_most(settings_.lift_damping_N_s_per_m * (Eigen::Vector3d::UnitY() * speed - seen), most_N);
  force_N_ += at_most(wanted_N - force_N_, kSlew_N_per_s * dt_s);
  return force_N_;
}

}  // namespace telepalp::control
