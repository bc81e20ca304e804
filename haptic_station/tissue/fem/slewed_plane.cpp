#include "haptic_station/tissue/fem/slewed_plane.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace telepalp::tissue {

using Eigen::Vector3d;

namespace {

constexpr double kLeastCosine = 0.5;

bool is_empty(const LocalPlane& model) noexcept { return model.normal.isZero(0.0); }

}  // namespace

void SlewedPlane::begin(const Vector3d& tool_m) noexcept {
  tank_ = EnergyTank(settings_.tank_J, settings_.tank_holds_J);
  tool_m_ = tool_m;
  depth_m_ = 0.0;
  stiffness_N_per_m_ = 0.0;
  shown_ = 1.0;
}

void SlewedPlane::take(const LocalPlane& model) noexcept {
  if (!is_empty(model) && !model.usable()) return;
  model_ = model;
  model_.stiffness_N_per_m = std::min(model.stiffness_N_per_m, settings_.stiffest_N_per_m);
  age_s_ = 0.0;
  follows_ = true;
}

/// Without a force, the model's spring takes the place of the old one, as deep as it may be without a force.
void SlewedPlane::begin_force() noexcept {
  normal_ = model_.normal;
  stiffness_N_per_m_ = model_.stiffness_N_per_m;
  depth_m_ = std::min(0.0, model_.depth_m(tool_m_));
}

/// At the same force f, the energy f^2 / (2 stiffness) of a softer spring is larger.
void SlewedPlane::stiffen() noexcept {
  const double force = force_N();
  const double before_J = energy_J();
  const double wanted_J = 0.5 * force * force / model_.stiffness_N_per_m;
  double after_J = wanted_J;
  if (wanted_J > before_J)
    after_J = before_J + tank_.pay(wanted_J - before_J);
  else
    tank_.fill((before_J - wanted_J) * shown_ * (2.0 - shown_));
  stiffness_N_per_m_ = 0.5 * force * force / after_J;
  depth_m_ = force / stiffness_N_per_m_;
}

/// Turns the direction towards the model's. Returns the change of the force, at most `most_N`. The energy stays.
double SlewedPlane::turn(double most_N) noexcept {
  const double away = (model_.normal - normal_).norm();
  const double change_N = force_N() * away;
  if (change_N <= most_N) {
    normal_ = model_.normal;
    return change_N;
  }
  normal_ = (normal_ + most_N / change_N * (model_.normal - normal_)).normalized();
  return most_N;
}

/// Changes the depth towards `wanted_m`, and the force by at most `most_N`.
void SlewedPlane::deepen(double wanted_m, double most_N) noexcept {
  const double most_m = most_N / stiffness_N_per_m_;
  if (wanted_m <= depth_m_) {
    const double after_m = depth_m_ > most_m ? std::max(wanted_m, depth_m_ - most_m) : wanted_m;
    const double hidden_m = (1.0 - shown_) * depth_m();  // by which the spring was relaxed when it was displayed
    const double before = std::max(0.0, depth_m() - hidden_m);
    const double after = std::max(0.0, after_m - hidden_m);
    tank_.fill(0.5 * stiffness_N_per_m_ * (before * before - after * after));
    depth_m_ = after_m;
    return;
  }
  const double before_m = depth_m();
  const double after_m = std::min(wanted_m, before_m + most_m);
  if (after_m <= 0.0) {
    depth_m_ = after_m;
    return;
  }
  const double paid_J = tank_.pay(0.5 * stiffness_N_per_m_ * (after_m * after_m - before_m * before_m));
  depth_m_ = std::min(after_m, std::sqrt(before_m * before_m + 2.0 * paid_J / stiffness_N_per_m_));
}

/// Lowers the force by `by_N`, also while the tool goes `deeper_m` deeper into a plane that is no longer there.
void SlewedPlane::release(double by_N, double deeper_m) noexcept {
  if (stiffness_N_per_m_ == 0.0) return;
  deepen(std::min(0.0, depth_m_), by_N + stiffness_N_per_m_ * std::max(0.0, deeper_m));
}

void SlewedPlane::step(const Vector3d& tool_m, double dt_s, double shown) noexcept {
  const double deeper_m = -normal_.dot(tool_m - tool_m_);
  depth_m_ += deeper_m;
  tool_m_ = tool_m;
  shown_ = std::clamp(shown, 0.0, 1.0);
  age_s_ += dt_s;
  if (age_s_ > settings_.held_s) follows_ = false;
  const double most_N = settings_.slew_N_per_s * dt_s;
  if (!follows_ || is_empty(model_)) {
    release(follows_ ? most_N : settings_.release_N_per_s * dt_s, deeper_m);
    if (depth_m_ <= 0.0) stiffness_N_per_m_ = 0.0;  // a tool that comes back feels nothing
    return;
  }
  if (depth_m_ <= 0.0 || stiffness_N_per_m_ == 0.0) begin_force();
  if (force_N() > 0.0 && normal_.dot(model_.normal) < kLeastCosine) return release(most_N, deeper_m);
  if (force_N() > 0.0) stiffen();
  const double turned_N = turn(0.5 * most_N);
  deepen(model_.depth_m(tool_m_), most_N - turned_N);
}

}  // namespace telepalp::tissue
