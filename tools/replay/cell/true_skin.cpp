#include "tools/replay/cell/true_skin.h"

#include <algorithm>
#include <cmath>

namespace telepalp::replay {
namespace {

constexpr double kNear_m = 0.045;  // at a larger distance from the skin the nearest point is not computed

/// As the controller decides whether the skin gives force.
bool is_touching(const loop::TickOut& act) noexcept {
  const bool may_feel = control::is_inside(act.control.phase) || act.control.phase == control::Phase::BodyToPlane;
  return may_feel && act.contact.valid && act.contact.in_body;
}

bool is_at_object(control::Phase phase) noexcept {
  return control::is_inside(phase) && phase != control::Phase::InBody;
}

}  // namespace

TickRecord judged(const TickOutcome& tick, const Transform<HapticBase, DepthCamera>& haptic_from_camera,
                  const std::optional<capture::TrueSurface>& surface, const effects::SkinLaw* law, double peak_N) {
  const loop::TickOut& act = tick.act;
  TickRecord record{.force_N = act.force.N.cast<float>(),
                    .device_m = tick.device.m,
                    .phase = act.control.phase,
                    .touching = is_touching(act),
                    .felt = control::is_inside(act.control.phase),
                    .surface_age_s = static_cast<float>(act.contact.age_s),
                    .passivity_J = static_cast<float>(act.control.passivity_J),
                    .hand_excess_J = static_cast<float>(act.control.hand_excess_J)};
  if (!surface || tick.device.m.y() > 2.0 * kNear_m) return record;
  const auto foot = surface->closest_to(haptic_from_camera.inverse() * tick.device);
  if (!foot || !foot->on_body) return record;
  const Eigen::Vector3d normal = (haptic_from_camera * foot->normal).v;
  const double depth_m = normal.dot((haptic_from_camera * foot->at).m - tick.device.m);
  record.depth_m = static_cast<float>(depth_m);
  if (act.contact.valid && std::abs(depth_m) < kNear_m)
    record.surface_off_m = static_cast<float>(act.contact.distance_m + depth_m);
  if (law == nullptr || is_at_object(act.control.phase) || (depth_m <= 0.0 && !record.felt)) return record;
  const double law_N = depth_m > 0.0 ? std::min(peak_N, effects::skin_force_N(*law, depth_m * normal).norm()) : 0.0;
  record.law_N = static_cast<float>(law_N);
  record.off_truth_N = static_cast<float>(act.force.N.dot(normal) - law_N);
  return record;
}

}  // namespace telepalp::replay
