#include "tools/study/designer/live/reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::study {
namespace {

using mechanism::HeldLinkage;
constexpr double kStep_rad = std::numbers::pi / 90.0;

ReachPoint point_at(const HeldLinkage& held, double link3_rad) {
  const HeldLinkage there(held.bar(), held.plane(), link3_rad, held.branch());
  return {.link3_rad = link3_rad,
          .hand_m = there.grasp().m.head<2>(),
          .tip_m = there.tip().m.head<2>(),
          .hand_N = there.hand_force({-there.needle_axis().v}).N.norm()};
}

}  // namespace

Reach reach_of(const HeldLinkage& held) {
  Reach reach{.grashof = mechanism::grashof_class(held.bar()),
              .range = mechanism::crank_range(held.bar(), held.link3_rad()),
              .points = {}};
  const bool whole = reach.range.whole_turn;
  const double from_rad = whole ? held.link3_rad() - std::numbers::pi : reach.range.from_rad;
  const double to_rad = whole ? held.link3_rad() + std::numbers::pi : reach.range.to_rad;
  const int steps = std::max(1, static_cast<int>(std::ceil((to_rad - from_rad) / kStep_rad)));
  for (int i = 0; i <= steps; ++i)
    reach.points.push_back(point_at(held, i == steps ? to_rad : from_rad + (to_rad - from_rad) * i / steps));
  return reach;
}

}  // namespace telepalp::study
