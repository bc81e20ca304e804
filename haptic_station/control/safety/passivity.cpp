#include "haptic_station/control/safety/passivity.h"

#include <algorithm>

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {
namespace {

constexpr double kTolerance_J = 1e-5;      // a smaller excess of energy is ignored as rounding and quantisation
constexpr double kHandTolerance_J = 1e-4;  // a smaller excess in HandLedger is ignored as noise of the surface
// The damping force changes by at most 0.045 N a tick, less the change of the effects' force in the same tick. It may
// always change by 0.02 N.
constexpr double kSlew_N_per_s = 90.0;
constexpr double kLeastSlew_N_per_s = 40.0;

}  // namespace

double PassivityController::Damper::follow(double excess_J, double speed2_m2_per_s2, double dt_s) noexcept {
  constexpr double kStill_m2_per_s2 = 1e-8;  // 0.1 mm/s: a slower movement dissipates no energy
  double wanted = 0.0;
  if (excess_J > 0.0)
    wanted = std::min(most_N_s_per_m, excess_J / (std::max(speed2_m2_per_s2, kStill_m2_per_s2) * reaction_s));
  const double most_change = most_N_s_per_m * dt_s / reaction_s;
  now_N_s_per_m += std::clamp(wanted - now_N_s_per_m, -most_change, most_change);
  return now_N_s_per_m;
}

void PassivityController::begin(double stored_J) noexcept {
  taken_J_ = stored_J_ = stored_J;
  display_.now_N_s_per_m = hand_.now_N_s_per_m = 0.0;
  damping_ = {};
}

Wrench<HapticBase> PassivityController::step(const Exchange& exchange, double dt_s) noexcept {
  const double damped_J = -damping_.force.N.dot(exchange.moved.v) - damping_.torque.N_m.dot(exchange.turned.v);
  taken_J_ += exchange.absorbed_J + damped_J;
  dissipated_J_ += damped_J;
  stored_J_ = exchange.stored_J;
  least_J_ = std::min(least_J_, balance_J());

  const Eigen::Vector3d& relative = exchange.velocity.v;
  const Eigen::Vector3d& absolute = exchange.device_velocity.v;
  const Eigen::Vector3d turning = exchange.lever_m * exchange.turning.v;
  const double turning2 = turning.squaredNorm();
  const double display_excess_J = -balance_J() - kTolerance_J;
  const double hand_excess_J = exchange.hand_excess_J - kHandTolerance_J;
  const double by_display = display_.follow(display_excess_J, relative.squaredNorm() + turning2, dt_s);
  const double by_hand = hand_.follow(hand_excess_J, absolute.squaredNorm() + turning2, dt_s);
  const Eigen::Vector3d wanted_N = -by_display * relative - by_hand * absolute;
  const double most_change_N = std::max(kLeastSlew_N_per_s * dt_s, kSlew_N_per_s * dt_s - exchange.force_change_N);
  damping_.force.N += at_most(wanted_N - damping_.force.N, most_change_N);
  const Eigen::Vector3d wanted_N_m = -exchange.lever_m * (by_display + by_hand) * turning;
  damping_.torque.N_m += at_most(wanted_N_m - damping_.torque.N_m, exchange.lever_m * most_change_N);
  if (exchange.lever_m <= 0.0) damping_.torque = {};
  return damping_;
}

}  // namespace telepalp::control
