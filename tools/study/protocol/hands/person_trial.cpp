#include "tools/study/protocol/hands/person_trial.h"

#include <algorithm>

namespace telepalp::study {
namespace {

std::array<float, 3> floats(const Eigen::Vector3d& v) noexcept {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

TrialView view_of(const Prepared& prepared, double way_m) noexcept {
  constexpr double kStep_m = 1e-4;
  const HeldTool& tool = *prepared.tool;
  const Eigen::Vector3d ahead_m = tool.on_the_way_m(way_m + kStep_m) - tool.on_the_way_m(way_m - kStep_m);
  const Insertion& insertion = *prepared.insertion;
  return {.picture = tool.picture(),
          .along = ahead_m.head<2>().normalized(),
          .through_skin = insertion.tissue().layer(0).state == tissue::LayerState::Inserted,
          .needle_N = insertion.needle_N().norm(),
          .moved = insertion.time_s() > 0.0,
          .over = insertion.over(),
          .held_up_s = 0.0,
          .outcome = insertion.outcome()};
}

loop::TickSample tick_of(const Prepared& prepared, const Eigen::Vector3d& hand_m,
                         const Eigen::Vector3d& shown_N) noexcept {
  const Insertion& insertion = *prepared.insertion;
  loop::TickSample tick;
  tick.in_body = insertion.depth_m() > 0.0;
  tick.hand = floats(hand_m);
  tick.device = tick.hand;
  tick.proxy = floats(prepared.tool->tip_m());
  tick.normal = {0.0F, 1.0F, 0.0F};
  tick.force = floats(shown_N);
  tick.indentation_m = static_cast<float>(std::max(0.0, insertion.depth_m()));
  tick.distance_m = static_cast<float>(-insertion.depth_m());
  return tick;
}

}  // namespace telepalp::study
