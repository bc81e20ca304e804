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
  withheld_ = {};
  shown_N_.setZero();
}

Wrench<HapticBase> EnergyAccount::step(const Wrench<HapticBase>& asked, double share, const Exchange& exchange,
                                       double bound_N, double dt_s) noexcept {
  const Eigen::Vector3d& asked_N = asked.force.N;
  Exchange booked = exchange;
  booked.absorbed_J -= withheld_.force.N.dot(exchange.moved.v);
  booked.absorbed_J -= withheld_.torque.N_m.dot(exchange.turned.v);
  // The force is bounded before the damping is added. Otherwise the limiter would cut the damping off.
  const Eigen::Vector3d shown_N = at_most(share * asked_N, bound_N);
  const Eigen::Vector3d shown_N_m = at_most(share * asked.torque.N_m, exchange.lever_m * bound_N);
  booked.force_change_N = (shown_N - std::exchange(shown_N_, shown_N)).norm();
  withheld_ = {.force = {shown_N - asked_N}, .torque = {shown_N_m - asked.torque.N_m}};
  booked.stored_J *= share * deliverable_share(bound_N, share * asked_N.norm());
  damping_ = passivity_.step(booked, dt_s);
  return {.force = {shown_N + damping_.force.N}, .torque = {shown_N_m + damping_.torque.N_m}};
}

void EnergyAccount::limited(const Wrench<HapticBase>& given, const Wrench<HapticBase>& wanted) noexcept {
  withheld_.force.N += given.force.N - wanted.force.N;
  withheld_.torque.N_m += given.torque.N_m - wanted.torque.N_m;
}

/// A torque that the device lacks is no deviation: the contact's force is displayed in full.
bool EnergyAccount::withholds() const noexcept {
  constexpr double kRounding_N2 = 1e-18;
  return withheld_.force.N.squaredNorm() > kRounding_N2;
}

}  // namespace telepalp::control
