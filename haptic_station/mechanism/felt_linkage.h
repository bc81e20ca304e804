#pragma once

#include <array>
#include <optional>

#include "haptic_station/mechanism/held_linkage.h"
#include "haptic_station/mechanism/link_parts.h"
#include "haptic_station/mechanism/planar_mechanism.h"
#include "haptic_station/solids/rods.h"
#include "haptic_station/solids/solid_proxy.h"

namespace telepalp::mechanism {

/// How a linkage is felt.
struct FeltSettings {
  double stiffness_N_per_m = 500.0;  ///< of a part that is touched, and of the grasp: K_c of S4 eq. (8)
  double link_radius_m = 0.006;      ///< of links and handle
  double needle_radius_m = 0.0007;   ///< 17G: a needle of 1.4 mm
  double hand_radius_m = 0.003;      ///< of the sphere that stands for the hand
  SlewLimits slew{};                 ///< how fast parameters move to the values that set() gave
};

/// A four-bar linkage that a hand feels and takes hold of, as paper S4 (docs/sources.md), section 2, has it: its links,
/// handle and needle are rods with round ends, and the hand is a small sphere. A button that is pressed during a touch
/// attaches the hand to the part that it touches, at the place of the touch; from then on the hand moves the linkage by
/// that part, until the button is let go. A button that was pressed before the touch attaches nothing.
///
/// A linkage that nobody holds stays where it is, as if a brake held it: it has no mass, and S4 gives none.
///
/// Neither taking hold nor letting go makes a step of force. The proxy of the touch becomes the held point, and the
/// spring to it has the same stiffness; the linkage, which has no mass, then comes to the hand within kComes_s, not at
/// once. After letting go, what the grasp's force was more than the touch's falls off within kFades_s. A hand that
/// begins or lets go inside a part feels no part until it has left all of them. Pure: step() does not allocate. Owner:
/// the thread that calls step().
class FeltLinkage {
 public:
  static constexpr double kComes_s = 0.05;  ///< time constant
  static constexpr double kFades_s = 0.03;  ///< time constant

  /// The linkage as `at` has it. Error: as of assembled().
  [[nodiscard]] static Result<FeltLinkage> make(const HeldLinkage& at, const FeltSettings& settings = {});

  /// Changes the linkage to `bar`, which has passed checked_at() for link3_rad(), while it is in use. step() moves all
  /// parameters evenly, so that neither pose nor force has a step; at a pose from which the joints would not close,
  /// they wait. The hand keeps its share of the part that it holds.
  void set(const FourBar& bar) noexcept { wanted_ = bar; }

  /// One tick. `pressed`: the hand presses its button. A hand that is not finite moves nothing and feels nothing.
  void step(const Point<HapticBase>& hand, bool pressed, double dt_s) noexcept;
  /// The hand takes hold of `part` at the point of its axis nearest to `at`, and is there. Base: it lets go instead.
  void hold(LinkPart part, const Point<HapticBase>& at) noexcept;
  void let_go() noexcept;
  /// The hand is no longer known, as when its device falls silent: nobody holds the linkage, and the next step() begins
  /// as the first one did. A button that is pressed then must be let go first.
  void forget_hand() noexcept;

  [[nodiscard]] std::optional<LinkPart> held() const noexcept { return held_; }
  /// The part that the hand touches; nullopt: none, or the hand holds one.
  [[nodiscard]] std::optional<LinkPart> touched() const noexcept { return touched_; }
  /// Proxy of the hand: the held point, the point of touch, or the hand itself.
  [[nodiscard]] Point<HapticBase> proxy() const noexcept { return {proxy_m_}; }

  /// Force on the hand of what it touches, or of the grasp, which keeps it on the path of the held point and in the
  /// linkage's plane: S4 eq. (8).
  [[nodiscard]] Force<HapticBase> contact_force() const noexcept { return {spring_N() + fading_N_}; }
  /// Force on the hand of the force `at_tip` on the needle's tip: HeldMechanism::hand_force_N(). Zero while nobody
  /// holds the linkage.
  [[nodiscard]] Force<HapticBase> hand_force(const Force<HapticBase>& at_tip) const noexcept;

  [[nodiscard]] Point<HapticBase> tip() const noexcept { return in_space(mechanism_.tip_m()); }
  [[nodiscard]] Vector<HapticBase> needle_axis() const noexcept;  ///< unit vector to the tip
  [[nodiscard]] const FourBar& bar() const noexcept { return bar_; }
  [[nodiscard]] const LinkagePlane& plane() const noexcept { return plane_; }
  [[nodiscard]] FourBarPose<double> pose() const noexcept;  ///< in the linkage's frame
  [[nodiscard]] double link3_rad() const noexcept { return mechanism_.pose()[8]; }
  /// Sine of the angle between links 1 and 2: 0 at a dead point of the handle.
  [[nodiscard]] double sine_of_links() const noexcept;

 private:
  struct Line {
    Eigen::Vector3d from_m;
    Eigen::Vector3d to_m;
  };
  /// Where the hand holds a part, in the plane; see on_part().
  struct Grasp {
    double share = 0.0;
    double across_m = 0.0;
  };
  FeltLinkage(const HeldLinkage& at, const HeldMechanism& mechanism, solids::Rods rods,
              const FeltSettings& settings) noexcept;
  [[nodiscard]] Eigen::Vector3d spring_N() const noexcept { return settings_.stiffness_N_per_m * (proxy_m_ - hand_m_); }
  [[nodiscard]] Eigen::Vector2d in_plane(const Eigen::Vector3d& at_m) const noexcept;
  [[nodiscard]] Point<HapticBase> in_space(const Eigen::Vector2d& at_m, double off_plane_m = 0.0) const noexcept;
  [[nodiscard]] Eigen::Vector3d normal() const noexcept { return plane_.x.v.cross(plane_.y.v); }
  [[nodiscard]] std::array<Line, kLinkParts> lines() const noexcept;
  [[nodiscard]] double radius_m(LinkPart part) const noexcept;
  [[nodiscard]] LinkPart part_at(const Eigen::Vector3d& at_m) const noexcept;
  void place_rods() noexcept;
  void approach_wanted(double dt_s) noexcept;
  void touch() noexcept;
  void attach(LinkPart part, const Eigen::Vector3d& at_m) noexcept;

  FourBar bar_;
  FourBar wanted_;
  LinkagePlane plane_;
  FeltSettings settings_;
  HeldMechanism mechanism_;
  solids::Rods rods_;
  solids::SolidProxy touch_;
  std::optional<LinkPart> held_;
  std::optional<LinkPart> touched_;
  Grasp grasp_;
  Eigen::Vector3d hand_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d proxy_m_ = Eigen::Vector3d::Zero();
  double off_plane_m_ = 0.0;                                   // of the held point
  Eigen::Vector2d still_to_come_m_ = Eigen::Vector2d::Zero();  // from the hand to the place that the linkage follows
  Eigen::Vector3d fading_N_ = Eigen::Vector3d::Zero();
  bool pressed_ = true;  // at the last step
  bool inside_ = true;   // the hand has not been outside all parts since it began or let go
};

}  // namespace telepalp::mechanism
