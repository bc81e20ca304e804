#include "haptic_station/control/parts/position_control.h"

#include "haptic_station/control/parts/coming_hand.h"
#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

constexpr double kHandSmoothing_rad_per_s = 25.0;  // bandwidth of the filter over the tracker's 100 Hz steps
constexpr double kHeightSmoothing_s = 0.02;        // time constant of the filter over the target's vertical speed

}  // namespace

void PositionControl::begin(const ControlInput& in, double target_height_m, const Vector3d& from_N) noexcept {
  hand_ = {in.hand.m, in.hand_velocity.v};
  hand_.per_s.y() = 0.0;
  const Vector3d goal{in.hand.m.x(), target_height_m, in.hand.m.z()};
  height_m_ = target_height_m;
  rises_m_per_s_ = 0.0;
  offset_ = {in.device.m - goal, in.device_velocity.v - hand_.per_s};
  force_N_ = from_N;
}

/// The speed of the followed hand is limited to `fastest_m_per_s`, and so is the speed that its position steps imply.
void PositionControl::follow_hand(const ControlInput& in, double dt_s) noexcept {
  const Moving error =
      toward_zero({hand_.m - in.hand.m, hand_.per_s - in.hand_velocity.v}, kHandSmoothing_rad_per_s, dt_s);
  hand_.per_s = at_most(in.hand_velocity.v + error.per_s, settings_.fastest_m_per_s);
  const Vector3d step = in.hand.m + in.hand_velocity.v * dt_s + error.m - hand_.m;
  hand_.m += at_most(step, settings_.fastest_m_per_s * dt_s);
}

/// Updates the smoothed vertical speed of the target. The waiting plane moves at a bounded speed, but starts and stops
/// abruptly. The end-effector must not lag behind the plane, because the skin is below it.
void PositionControl::follow_height(double target_height_m, double dt_s) noexcept {
  if (dt_s > 0.0) {
    const double raw_m_per_s = (target_height_m - height_m_) / dt_s;
    rises_m_per_s_ += (raw_m_per_s - rises_m_per_s_) * (dt_s / (kHeightSmoothing_s + dt_s));
  }
  height_m_ = target_height_m;
}

Vector3d PositionControl::step(const ControlInput& in, double target_height_m, double dt_s) noexcept {
  follow_hand(in, dt_s);
  follow_height(target_height_m, dt_s);
  offset_ = toward_zero(offset_, 1.0 / offset_fade_s_, dt_s);
  target_.m = Vector3d{hand_.m.x(), target_height_m, hand_.m.z()} + offset_.m;
  const Vector3d speed = Vector3d{hand_.per_s.x(), rises_m_per_s_, hand_.per_s.z()} + offset_.per_s;
  Vector3d wanted_N = at_most(settings_.stiffness_N_per_m * (target_.m - in.device.m) +
                                  settings_.damping_N_s_per_m * (speed - in.device_velocity.v),
                              settings_.most_N);
  if (hand_comes(in)) wanted_N = yielding(in, wanted_N, settings_.against_hand_N);
  force_N_ += at_most(wanted_N - force_N_, settings_.slew_N_per_s * dt_s);
  return force_N_;
}

}  // namespace telepalp::control
