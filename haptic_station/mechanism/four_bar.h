#pragma once

#include <numbers>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::mechanism {

/// A four-bar linkage with a needle and a handle, as paper S4 (docs/sources.md) describes it by its Figures 2 and 8.
///
/// Frame of the linkage: link 4 is fixed and lies on x, from pivot A at 0 to pivot O at x = l4. Link 1 turns about A
/// and ends at P. Link 3 turns about O and ends at B. Link 2 joins P and B. The patient is at negative x. Angles are
/// counter-clockwise, except the handle's.
struct FourBar {
  double l1_m = 0.08;
  double l2_m = 0.15;
  double l3_m = 0.12;
  double l4_m = 0.13;
  double needle_rad = -0.31;  ///< theta: from the direction B to P of link 2 to the needle, which begins at P
  double needle_m = 0.1;      ///< length of the needle; S4 does not give it
  double handle_rad = 0.0;    ///< phi: from the direction O to B of link 3, clockwise, to the handle
  double handle_at_m = 0.0;   ///< h: from O along link 3 to the handle's end D
  double handle_m = 0.14;     ///< l_h: length of the handle, from D to its end C, which the hand holds

  [[nodiscard]] bool operator==(const FourBar&) const noexcept = default;
};

/// Which links can turn fully. Source: Grashof's theorem: if the shortest link s and the longest one l satisfy
/// s + l < p + q, the shortest link turns fully relative to all others.
enum class GrashofClass {
  DoubleCrank,   ///< link 4 is the shortest: links 1 and 3 turn fully
  CrankOfLink1,  ///< link 1 is the shortest and turns fully; link 3 rocks
  CrankOfLink3,  ///< link 3 is the shortest and turns fully; link 1 rocks
  DoubleRocker,  ///< link 2 is the shortest and turns fully; links 1 and 3 rock
  TripleRocker,  ///< s + l > p + q: no link turns fully
  ChangePoint,   ///< s + l = p + q: all joints can lie on one line, where the linkage can change its branch
};
[[nodiscard]] GrashofClass grashof_class(const FourBar& bar) noexcept;
[[nodiscard]] std::string_view name(GrashofClass grashof) noexcept;

/// `bar`, if it can be built. Error: a parameter is not finite, a link has no length, the links cannot close, or the
/// handle ends at pivot O, where a hand has no lever. The error names the parameters and their values.
[[nodiscard]] Result<FourBar> checked(const FourBar& bar);

/// As checked(), and the links close while link 3 has the angle `link3_rad` to x.
[[nodiscard]] Result<FourBar> checked_at(const FourBar& bar, double link3_rad);

}  // namespace telepalp::mechanism
