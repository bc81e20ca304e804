#pragma once

#include <algorithm>
#include <cmath>

#include "haptic_station/tissue/fem/slewed_plane.h"

namespace telepalp::tissue {

inline constexpr double kTickOfPlane_s = 0.0005;

/// A plane across x at `at_m` that pushes towards +x.
inline LocalPlane wall(double stiffness_N_per_m, double at_m) {
  return {.normal = Eigen::Vector3d::UnitX(),
          .offset_m = at_m,
          .stiffness_N_per_m = stiffness_N_per_m,
          .at_m = {at_m, 0, 0}};
}

/// A displayed spring and a second account of its energy: what changes of the model add to it, tick by tick, as the
/// difference of its energies with the tool where it is now.
struct HandOver {
  explicit HandOver(const SlewSettings& settings = {}) : plane(settings) {}

  void begin(const Eigen::Vector3d& tool_m) {
    at_m = tool_m;
    plane.begin(tool_m);
  }
  void tick(const Eigen::Vector3d& to_m, double shown = 1.0) {
    const double moved_m = plane.normal().dot(to_m - at_m);
    const double depth_m = std::max(0.0, signed_m - moved_m);
    const double carried_J = 0.5 * plane.stiffness_N_per_m() * depth_m * depth_m;
    const Eigen::Vector3d before_N = plane.force_N() * plane.normal();
    const double stiffness = plane.stiffness_N_per_m();
    const double spent_J = plane.tank().paid_J() - plane.tank().filled_J();
    plane.step(to_m, kTickOfPlane_s, shown);
    signed_m = plane.signed_depth_m();
    const Eigen::Vector3d now_N = plane.force_N() * plane.normal();
    const double beyond_N =
        (now_N - before_N).norm() - std::max(stiffness, plane.stiffness_N_per_m()) * (to_m - at_m).norm();
    worst_step_N = std::max(worst_step_N, beyond_N);
    const double added_J = plane.energy_J() - carried_J;
    const double booked_J = plane.tank().paid_J() - plane.tank().filled_J() - spent_J;
    all_added_J += added_J;
    worst_unbooked_J = std::max(worst_unbooked_J, std::abs(added_J - booked_J));
    least_level_J = std::min(least_level_J, plane.tank().level_J());
    at_m = to_m;
  }
  void rest(double seconds, double shown = 1.0) {
    for (double t = 0.0; t < seconds; t += kTickOfPlane_s) tick(at_m, shown);
  }
  void move(const Eigen::Vector3d& to_m, double speed_m_per_s) {
    const Eigen::Vector3d from_m = at_m;
    const int ticks =
        std::max(1, static_cast<int>(std::ceil((to_m - from_m).norm() / (speed_m_per_s * kTickOfPlane_s))));
    for (int i = 1; i <= ticks; ++i) tick(from_m + (to_m - from_m) * i / ticks);
  }

  SlewedPlane plane;
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
  double signed_m = 0.0;
  double worst_step_N = 0.0;      ///< |change of force| - stiffness × |motion|
  double all_added_J = 0.0;       ///< by changes of the model
  double worst_unbooked_J = 0.0;  ///< in a tick
  double least_level_J = 1e9;
};

}  // namespace telepalp::tissue
