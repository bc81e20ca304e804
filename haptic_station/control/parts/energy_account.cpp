#include "haptic_station/control/parts/energy_account.h"

#include <utility>

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {
namespace {

/// The share of a spring's energy that the device can return, if the spring pushes with `force_N` and the device gives
/// at most `bound_N`.
double deliverable_share(double bound_N, double force_N) noexcept {
  if (force_N <= bound_N) return 1.0;
  const double share = bound_N / force_N;
  return share * (2.0 - share);
}

}  // namespace

void EnergyAccount::begin() noexcept {
  passivity_.begin(0.0);
  withheld_N_.setZero();
  shown_N_.setZero();
}

Eigen::Vector3d EnergyAccount::step(const Eigen::Vector3d& asked_N, double share, const Exchange& exchange,
                                    double bound_N, double dt_s) noexcept {
  Exchange booked = exchange;
  booked.absorbed_J -= withheld_N_.dot(exchange.moved.v);
  // The force is bounded before the damping is added. Otherwise the limiter would cut the damping off.
  const Eigen::Vector3d shown_N = at_most(share * asked_N, bound_N);
  booked.force_change_N = (shown_N - std::exchange(shown_N_, shown_N)).norm();
  withheld_N_ = shown_N - asked_N;
  booked.stored_J *= share * deliverable_share(bound_N, share * asked_N.norm());
  damping_ = passivity_.step(booked, dt_s);
  return shown_N + damping_.N;
}

void EnergyAccount::limited(const Eigen::Vector3d& given_N, const Eigen::Vector3d& wanted_N) noexcept {
  withheld_N_ += given_N - wanted_N;
}

bool EnergyAccount::withholds() const noexcept {
  constexpr double kRounding_N2 = 1e-18;
  return withheld_N_.squaredNorm() > kRounding_N2;
}

}  // namespace telepalp::control
