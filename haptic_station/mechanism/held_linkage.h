#pragma once

#include "haptic_station/mechanism/four_bar.h"
#include "haptic_station/mechanism/four_bar_pose.h"
#include "haptic_station/mechanism/slewed_bar.h"
#include "proto/words/frames.h"

namespace telepalp::mechanism {

/// Where the linkage is: its pivot A, and the unit vectors of its frame (FourBar), at a right angle to each other.
struct LinkagePlane {
  Point<HapticBase> pivot_a;
  Vector<HapticBase> x{Eigen::Vector3d::UnitX()};
  Vector<HapticBase> y{Eigen::Vector3d::UnitY()};
};

/// The branch of the loop: on which side of the vector AB joint P lies.
enum class Branch { Open, Crossed };

struct HoldSettings {
  double stiffness_N_per_m = 500.0;  ///< of the spring from the hand to the handle: K_c of S4 eq. (8)
  double held_share = 1.0;           ///< where the hand is on the handle: 0 at D, 1 at its end C
  double most_gain = 5.0;            ///< largest force on the hand, as a multiple of the force on the needle
  double fastest_rad_per_s = 50.0;   ///< greatest speed of link 3, also when a hand crosses pivot O
  SlewLimits slew{};                 ///< how fast parameters move to the values that set() gave
};

/// A hand that holds the handle of a four-bar linkage (S4 section 4.1). The linkage has no mass: link 3 turns by the
/// angle GOT from the hand's old place G to its new place T, and all others follow.
///
/// At a dead point links 1 and 2 lie on one line, and link 3 can turn no further. The linkage stays there while the
/// hand goes on, and goes back on the branch on which it came. A change-point linkage has no such end: there, link 1
/// goes on in the direction in which it turned. Pure. Owner: the thread that calls step().
class HeldLinkage {
 public:
  /// `bar` has passed checked_at() for `link3_rad`.
  HeldLinkage(const FourBar& bar, const LinkagePlane& plane, double link3_rad, Branch branch,
              const HoldSettings& settings = {}) noexcept;

  /// Changes the linkage to `bar`, which has passed checked(), while the hand holds it. step() moves all parameters
  /// evenly, at most as fast as the settings say, so that neither pose nor force has a step.
  void set(const FourBar& bar) noexcept { wanted_ = bar; }

  /// Moves the linkage to the hand at `hand` after `dt_s`. A hand that is not finite, or lies on the axis of pivot O,
  /// leaves the linkage where it is.
  void step(const Point<HapticBase>& hand, double dt_s) noexcept;

  [[nodiscard]] Point<HapticBase> grasp() const noexcept { return in_space(held_); }  ///< G' of S4 Figure 5
  [[nodiscard]] Point<HapticBase> tip() const noexcept { return in_space(pose_.tip); }
  [[nodiscard]] Vector<HapticBase> needle_axis() const noexcept;   ///< unit vector to the tip
  [[nodiscard]] Vector<HapticBase> tip_velocity() const noexcept;  ///< mean over the last step [m/s]
  [[nodiscard]] double link3_rad() const noexcept { return link3_rad_; }
  [[nodiscard]] Branch branch() const noexcept { return side_ > 0.0 ? Branch::Open : Branch::Crossed; }
  [[nodiscard]] const FourBar& bar() const noexcept { return bar_; }                ///< as it is now
  [[nodiscard]] const FourBarPose<double>& pose() const noexcept { return pose_; }  ///< in the linkage's frame
  [[nodiscard]] const LinkagePlane& plane() const noexcept { return plane_; }
  /// Sine of the angle between links 1 and 2, with the branch's sign: 0 at a dead point.
  [[nodiscard]] double sine_of_links() const noexcept;

  /// Force on the hand that holds it at the handle: S4 eq. (8), K_c times the vector from the hand to G'. It also draws
  /// the hand back into the linkage's plane. Zero if the hand of the last step() was not finite.
  [[nodiscard]] Force<HapticBase> constraint_force() const noexcept;

  /// Force on the hand of the force `at_tip` on the needle's tip. Virtual work: the hand's force times a motion of G'
  /// is the tip's force times the motion of the tip that belongs to it. Exact while its gain is at most `most_gain`;
  /// nearer to a dead point, where the gain has no bound, it stays at that gain. The part normal to the plane is left
  /// out: the linkage's bearings take it.
  [[nodiscard]] Force<HapticBase> hand_force(const Force<HapticBase>& at_tip) const noexcept;

  /// Distance that the tip moves for each metre that the hand moves: |dTip| / |dG'|, at most `most_gain`.
  [[nodiscard]] double tip_travel() const noexcept;

 private:
  struct Motion;  ///< of G' and of the tip in the same turn of link 3
  [[nodiscard]] Motion motion() const noexcept;
  [[nodiscard]] Point<HapticBase> in_space(const InPlane<double>& at) const noexcept;
  void turn_to(const InPlane<double>& hand, double dt_s) noexcept;
  void close_loop() noexcept;
  void choose_side() noexcept;
  void remember_turning(const FourBarPose<double>& pose) noexcept;

  FourBar bar_;
  FourBar wanted_;
  LinkagePlane plane_;
  HoldSettings settings_;
  double link3_rad_;
  double side_;  // +1 open, -1 crossed
  FourBarPose<double> pose_;
  InPlane<double> held_;    // G'
  Eigen::Vector3d hand_m_;  // T
  Eigen::Vector3d tip_velocity_ = Eigen::Vector3d::Zero();
  double link1_rad_ = 0.0;        // angle of link 1 when it was last away from a change point
  double link1_per_link3_ = 0.0;  // radians of link 1 for each radian of link 3, at that pose
  double left_at_rad_ = 0.0;      // angle of link 3 at that pose
};

}  // namespace telepalp::mechanism
