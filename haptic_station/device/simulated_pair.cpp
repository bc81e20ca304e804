#include "haptic_station/device/simulated_pair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::device {
namespace {

constexpr double kVelocityFilter_hz = 150.0;  // cut-off frequency of the reported velocity's filter

using Eigen::Vector3d;

struct Speeds {
  double hand;
  double device;
};

/// One axis of the model: hand and device are masses with dampers; the arm is a spring on the hand; the flesh is a
/// spring between hand and device.
struct Axis {
  double arm_gap_m;    ///< intended position minus hand
  double arm_speed;    ///< speed of the intended position [m/s]
  double flesh_gap_m;  ///< device minus hand, minus the flesh's rest length
  double motor_N;
};

/// Speeds after `dt`, with spring and damper forces taken at the end of the step (linearly implicit Euler).
Speeds after(const SimulatedDeviceSettings& d, const SimulatedHandSettings& h, const Axis& axis, const Speeds& v,
             double flesh_stiffness, double flesh_damping, double dt) noexcept {
  const double flesh = flesh_stiffness * dt + flesh_damping;
  const double a_hand = h.mass_kg / dt + h.stiffness_N_per_m * dt + h.damping_N_s_per_m + flesh;
  const double a_device = d.mass_kg / dt + d.damping_N_s_per_m + flesh;
  const double flesh_N = flesh_stiffness * axis.flesh_gap_m;
  const double b_hand = h.mass_kg / dt * v.hand + h.stiffness_N_per_m * axis.arm_gap_m +
                        (h.damping_N_s_per_m + h.stiffness_N_per_m * dt) * axis.arm_speed + flesh_N;
  const double b_device = d.mass_kg / dt * v.device + axis.motor_N - flesh_N;
  const double determinant = a_hand * a_device - flesh * flesh;
  return {(b_hand * a_device + flesh * b_device) / determinant, (a_hand * b_device + flesh * b_hand) / determinant};
}

/// Force of the flesh on the hand at the end of the step.
double flesh_on_hand_N(const Axis& axis, const Speeds& v, double stiffness, double damping, double dt) noexcept {
  return stiffness * (axis.flesh_gap_m + dt * (v.device - v.hand)) + damping * (v.device - v.hand);
}

}  // namespace

void SimulatedPair::place(const Point<HapticBase>& device, const Point<HapticBase>& hand) noexcept {
  *this = SimulatedPair(device_settings_, hand_settings_);
  device_ = reported_ = device;
  hand_ = hand;
}

Point<HapticBase> SimulatedPair::device() const noexcept {
  const double step = device_settings_.encoder_step_m;
  if (step <= 0.0) return device_;
  return {(device_.m / step).array().round().matrix() * step};
}

void SimulatedPair::step(const Force<HapticBase>& motors, const Intention& intention, double dt) noexcept {
  Vector3d motor_N = motors.N.allFinite() ? motors.N : Vector3d::Zero().eval();
  saturated_ = motor_N.norm() > device_settings_.peak_N;
  if (saturated_) motor_N *= device_settings_.peak_N / motor_N.norm();

  const Vector3d gap = device_.m - hand_.m;
  const bool in_reach = std::hypot(gap.x(), gap.z()) <= hand_settings_.reach_m;
  // Contact begins only from above. A hand that comes from the side and is lower than the end-effector is beside it.
  bool pressing = in_reach && gap.y() >= 0.0 && (touching_ || was_above_);
  was_above_ = gap.y() <= 0.0;
  if (pressing && !touching_) grip_m_ = -gap;

  const auto solve = [&](int i, bool flesh) {
    const double rest = i == 1 ? 0.0 : -grip_m_[i];
    const Axis axis{intention.at.m[i] - hand_.m[i], intention.velocity.v[i], gap[i] - rest, motor_N[i]};
    const double stiffness = flesh ? hand_settings_.pad_stiffness_N_per_m : 0.0;
    const double damping = flesh ? hand_settings_.pad_damping_N_s_per_m : 0.0;
    const Speeds v = after(device_settings_, hand_settings_, axis, {hand_velocity_.v[i], device_velocity_.v[i]},
                           stiffness, damping, dt);
    felt_.N[i] = flesh ? flesh_on_hand_N(axis, v, stiffness, damping, dt) : 0.0;
    return v;
  };
  const auto slide = [&](int i, double slip_N) {
    const Axis axis{intention.at.m[i] - hand_.m[i] + slip_N / hand_settings_.stiffness_N_per_m, intention.velocity.v[i],
                    0.0, motor_N[i] - slip_N};
    return after(device_settings_, hand_settings_, axis, {hand_velocity_.v[i], device_velocity_.v[i]}, 0.0, 0.0, dt);
  };
  Speeds speeds[3];
  speeds[1] = solve(1, pressing);
  if (pressing && felt_.N.y() < 0.0) {  // flesh does not stick: a pull of the damper ends the contact
    pressing = false;
    was_above_ = true;  // the hand leaves upwards with its flesh still compressed; it may touch again at the next step
    speeds[1] = solve(1, false);
  }
  for (const int i : {0, 2}) speeds[i] = solve(i, pressing);
  const double sideways_N = std::hypot(felt_.N.x(), felt_.N.z());
  const double grip_N = hand_settings_.friction * felt_.N.y();
  if (pressing && sideways_N > grip_N) {
    // Slip: the tangential force is Coulomb's, and the grip point moves to where the flesh gives this force.
    for (const int i : {0, 2}) {
      const double slip_N = felt_.N[i] * (grip_N / sideways_N);
      speeds[i] = slide(i, slip_N);
      felt_.N[i] = slip_N;
      grip_m_[i] = slip_N / hand_settings_.pad_stiffness_N_per_m - gap[i];
    }
  }
  touching_ = pressing;
  for (int i = 0; i < 3; ++i) {
    hand_velocity_.v[i] = speeds[i].hand;
    device_velocity_.v[i] = speeds[i].device;
  }
  hand_.m += hand_velocity_.v * dt;
  device_.m += device_velocity_.v * dt;

  const Point<HapticBase> now = device();
  const double share = 1.0 - std::exp(-2.0 * std::numbers::pi * kVelocityFilter_hz * dt);
  reported_velocity_.v += ((now.m - reported_.m) / dt - reported_velocity_.v) * share;
  reported_ = now;
}

}  // namespace telepalp::device
