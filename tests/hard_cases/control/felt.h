#pragma once

#include <algorithm>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/device/simulated_pair.h"

namespace telepalp::hard_cases {

inline constexpr double kPeak_N = 10.0;  ///< of the device's force
inline constexpr double kTick_N = 0.17;  ///< the limiter's slew, over one tick

/// Figures of a run at the hand, to compare with their limits.
struct Felt {
  double worst_step_N = 0.0;    ///< largest change of the force in one tick
  double most_N = 0.0;          ///< the largest force
  double fastest_device = 0.0;  ///< [m/s]
  double energy_out_J = 0.0;    ///< largest net energy that the display gave in the body
  int changes = 0;              ///< changes of the phase
  int body_entries = 0;
  int let_gos = 0;  ///< changes to Released, and to Faulted
  bool finite = true;
  bool faulted = false;
  control::ControlOutput last;

  /// Adds one tick: the force `out` was held for `dt_s` while the pair moved on from `before`.
  void add(const control::ControlOutput& out, const device::SimulatedPair& before, const device::SimulatedPair& after,
           double dt_s) {
    const Eigen::Vector3d moved_m =
        after.true_device().m - before.true_device().m - Eigen::Vector3d::UnitY() * out.surface_speed_m_per_s * dt_s;
    if (control::is_inside(out.phase)) taken_J_ -= out.force.N.dot(moved_m);
    energy_out_J = std::max(energy_out_J, -taken_J_);
    worst_step_N = std::max(worst_step_N, (out.force.N - last.force.N).norm());
    most_N = std::max(most_N, out.force.N.norm());
    fastest_device = std::max(fastest_device, after.true_device_velocity().v.norm());
    finite = finite && out.force.N.allFinite() && out.displayed_hand.m.allFinite();
    faulted = faulted || out.phase == control::Phase::Faulted;
    if (out.phase != out.previous) ++changes;
    if (out.phase != out.previous && control::has_let_go(out.phase)) ++let_gos;
    if (control::is_inside(out.phase) && !control::is_inside(out.previous)) ++body_entries;
    last = out;
  }

 private:
  double taken_J_ = 0.0;  ///< energy that the display took from the hand
};

}  // namespace telepalp::hard_cases
