#pragma once

#include <numbers>

#include "haptic_station/mechanism/four_bar.h"

namespace telepalp::mechanism {

/// Tolerance of Grashof's equality s + l = p + q (GrashofClass::ChangePoint), relative to the sum of all links.
inline constexpr double kChangePointTolerance = 1e-9;

inline constexpr double kTurn_rad = 2.0 * std::numbers::pi;  ///< a whole turn

/// The angles of link 3 at which the loop closes, around a given angle [rad]. At both ends, links 1 and 2 lie on one
/// line: these are the dead points.
struct CrankRange {
  double from_rad = 0.0;
  double to_rad = 0.0;
  bool whole_turn = false;  ///< the loop closes at each angle; the ends mean nothing

  [[nodiscard]] bool has(double link3_rad) const noexcept {
    return whole_turn || (from_rad <= link3_rad && link3_rad <= to_rad);
  }
  [[nodiscard]] double nearest(double link3_rad) const noexcept;
};

/// The range in which link 3 can turn without taking the linkage apart, for a linkage that passes checked(). If there
/// are two ranges, on both sides of link 4, it is the one on the side of `near_rad`. The ends are continuous functions
/// of the lengths. Source: triangle inequality of links 1 and 2 over the distance AB; Freudenstein's discriminant is 0
/// there.
[[nodiscard]] CrankRange crank_range(const FourBar& bar, double near_rad) noexcept;

}  // namespace telepalp::mechanism
