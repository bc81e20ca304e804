#include "haptic_station/loop/workspace_indexing.h"

#include <algorithm>
#include <cmath>

namespace telepalp::loop {

const Indexed& WorkspaceIndexing::step(const Point<HapticBase>& device, double dt_s) noexcept {
  now_.moved = {};
  now_.recall = {};
  if (!settings_.on || !device.m.allFinite()) return now_;
  const double seconds = std::isfinite(dt_s) ? std::clamp(dt_s, 0.0, 0.01) : 0.0;
  const Eigen::Vector3d off(device.m.x() - settings_.center_x_m, 0.0, device.m.z() - settings_.center_z_m);
  const double off_m = off.norm();
  const double beyond_m = off_m - settings_.touch_radius_m;
  now_.interacts = now_.interacts ? beyond_m <= 0.0 : beyond_m <= -kReEntry_m;
  if (beyond_m <= 0.0) return now_;
  const Eigen::Vector3d outwards = off / off_m;
  const double recall_N = std::min(settings_.recall_N_per_m * beyond_m, settings_.recall_most_N);
  now_.recall = {-recall_N * outwards};
  const Eigen::Vector3d before = now_.shift.v;
  Eigen::Vector3d next = before + settings_.shift_m_per_s_per_N * recall_N * seconds * outwards;
  next.x() = std::clamp(next.x(), -settings_.most_shift_x_m, settings_.most_shift_x_m);
  next.z() = std::clamp(next.z(), -settings_.most_shift_z_m, settings_.most_shift_z_m);
  now_.shift = {next};
  now_.moved = {next - before};
  return now_;
}

}  // namespace telepalp::loop
