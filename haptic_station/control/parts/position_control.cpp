#include "haptic_station/control/parts/position_control.h"

#include <algorithm>

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

constexpr double kHandSmoothing_rad_per_s = 25.0;  // bandwidth of the filter over the tracker's 100 Hz steps
constexpr double kSlew_N_per_s = 56.0;             // 0.028 N a tick

}  // namespace

void PositionControl::begin(const ControlInput& in, double target_height_m) noexcept {
  hand_ = {in.hand.m, in.hand_velocity.v};
  hand_.per_s.y() = 0.0;
  const Vector3d goal{in.hand.m.x(), target_height_m, in.hand.m.z()};
  offset_ = {in.device.m - goal, in.device_velocity.v - hand_.per_s};
  force_N_.setZero();
}

/// The speed of the followed hand is limited to `fastest_m_per_s`, and so is the speed that its position steps imply.
void PositionControl::follow_hand(const ControlInput& in, double dt_s) noexcept {
  const Moving error =
      toward_zero({hand_.m - in.hand.m, hand_.per_s - in.hand_velocity.v}, kHandSmoothing_rad_per_s, dt_s);
  hand_.per_s = at_most(in.hand_velocity.v + error.per_s, settings_.fastest_m_per_s);
  const Vector3d step = in.hand.m + in.hand_velocity.v * dt_s + error.m - hand_.m;
  hand_.m += at_most(step, settings_.fastest_m_per_s * dt_s);
}

Vector3d PositionControl::step(const ControlInput& in, double target_height_m, double dt_s) noexcept {
  follow_hand(in, dt_s);
  offset_ = toward_zero(offset_, 1.0 / offset_fade_s_, dt_s);
  target_.m = Vector3d{hand_.m.x(), target_height_m, hand_.m.z()} + offset_.m;
  const Vector3d speed = Vector3d{hand_.per_s.x(), 0.0, hand_.per_s.z()} + offset_.per_s;
  const Vector3d wanted_N = at_most(settings_.stiffness_N_per_m * (target_.m - in.device.m) +
                                        settings_.damping_N_s_per_m * (speed - in.device_velocity.v),
                                    settings_.most_N);
  force_N_ += at_most(wanted_N - force_N_, kSlew_N_per_s * dt_s);
  return force_N_;
}

Vector3d lift_force_N(const ControlInput& in, double target_height_m,
                      const PositionControlSettings& settings) noexcept {
  constexpr double kBrakes_s = 0.05;
  constexpr double kBeyond_m = 0.002;  // the lift aims above the plane, so that it reaches the plane
  const double left_m = target_height_m + kBeyond_m - in.device.m.y();
  const double speed = std::clamp(left_m / kBrakes_s, -settings.lift_speed_m_per_s, settings.lift_speed_m_per_s);
  const Vector3d wanted = Vector3d::UnitY() * speed;
  return at_most(settings.lift_damping_N_s_per_m * (wanted - in.device_velocity.v), settings.lift_most_N);
}

}  // namespace telepalp::control
