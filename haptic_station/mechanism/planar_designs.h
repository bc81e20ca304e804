#pragma once

#include <optional>

#include "haptic_station/mechanism/four_bar.h"
#include "haptic_station/mechanism/planar_mechanism.h"
#include "proto/words/result.h"

namespace telepalp::mechanism {

/// `mechanism` as a hand holds it. The pose in which all joints close is searched from `near` (Newton's method). Error:
/// a joint names no body, a number is not finite, the joints do not close from there (with the widest gap), or the
/// mechanism does not have one or two degrees of freedom.
[[nodiscard]] Result<HeldMechanism> assembled(const PlanarMechanism& mechanism, const PlanarPose& near);

/// A line from one point of a body to another one of the same body, to draw it.
struct PlanarLine {
  BodyPoint from;
  BodyPoint to;
};

/// A design and a pose near which it closes.
struct PlanarDesign {
  PlanarMechanism mechanism;
  PlanarPose near;
  BodyPoint needle_from{};                        ///< where the needle begins; it ends at the mechanism's tip
  std::optional<Eigen::Vector2d> hand_pivot_m{};  ///< in the frame: the held body turns about it; nullopt: about none
  ShortList<PlanarLine, 8> links{};               ///< without the needle
};

/// `bar` as bodies 1 (link 1), 2 (link 2 with the needle) and 3 (link 3 with the handle), while link 3 has `link3_rad`.
[[nodiscard]] PlanarDesign four_bar_design(const FourBar& bar, double link3_rad, bool open_branch = true);

/// A crank about the origin, which the hand holds at the distance `handle_m`, and a rod to a slider on the x axis. The
/// slider carries the needle, which points along -x.
struct SliderCrank {
  double crank_m = 0.06;
  double rod_m = 0.15;
  double handle_m = 0.14;
  double needle_m = 0.1;
};
[[nodiscard]] PlanarDesign slider_crank_design(const SliderCrank& crank, double crank_rad);

/// Two links that turn about (0, 0) and (base, 0), each with a link to the joint in which both meet. The hand moves
/// that joint anywhere in the plane: two degrees of freedom. The needle lies along the second link of the left chain.
struct FiveBar {
  double base_m = 0.1;
  double left_m = 0.1;
  double left_far_m = 0.12;
  double right_m = 0.1;
  double right_far_m = 0.12;
  double needle_m = 0.1;  ///< from the joint in which both chains meet, in the direction of the left far link
};
[[nodiscard]] PlanarDesign five_bar_design(const FiveBar& bar, const Eigen::Vector2d& joint_m);

/// Watt's six-bar linkage: the four-bar linkage `bar`, whose link 1 goes on beyond P by `arm_m`, with a link of
/// `rod_m` from there to a rocker of `rocker_m` about (`pivot_m`, 0). The needle continues this rod beyond the
/// rocker's end.
struct SixBar {
  FourBar bar;
  double arm_m = 0.04;
  double rod_m = 0.12;
  double rocker_m = 0.12;
  double pivot_m = -0.12;
  double needle_m = 0.08;  ///< from the rocker's end, in the rod's direction
};
[[nodiscard]] PlanarDesign six_bar_design(const SixBar& bar, double link3_rad);

}  // namespace telepalp::mechanism
