#pragma once

#include <Eigen/Core>
#include <vector>

#include "haptic_station/mechanism/crank_range.h"
#include "haptic_station/mechanism/held_linkage.h"

namespace telepalp::study {

/// A pose on the way of a linkage. Places in the plane z = 0 of the tissue's frame [m].
struct ReachPoint {
  double link3_rad = 0.0;
  Eigen::Vector2d hand_m;  ///< the handle's end
  Eigen::Vector2d tip_m;
  double hand_N = 0.0;  ///< force on the hand while 1 N pushes the needle back along its axis, with HoldSettings' bound
};

/// All poses that a linkage can take on the branch on which it is held.
struct Reach {
  mechanism::GrashofClass grashof = mechanism::GrashofClass::ChangePoint;
  mechanism::CrankRange range;
  std::vector<ReachPoint> points;  ///< by link3_rad; without a whole turn, the first and the last are dead points
};

/// Surveys `held` in even steps of at most 2 degrees. Pure.
[[nodiscard]] Reach reach_of(const mechanism::HeldLinkage& held);

}  // namespace telepalp::study
