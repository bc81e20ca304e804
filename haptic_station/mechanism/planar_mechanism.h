#pragma once

#include <Eigen/Core>
#include <array>
#include <initializer_list>

#include "proto/words/demand.h"

namespace telepalp::mechanism {

/// Most moving bodies of a planar mechanism, and most equations between them.
inline constexpr int kMostBodies = 6;
inline constexpr int kMostCoordinates = 3 * kMostBodies;
inline constexpr int kMostEquations = 20;

/// A point of a body, in the body's own axes [m]. Body 0 is the frame, which does not move; the others count from 1.
struct BodyPoint {
  int body = 0;
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
};

/// A revolute joint: both points are at one place. Two equations.
struct Pin {
  BodyPoint one;
  BodyPoint other;
};

/// `point` lies on the line through `line`, which has the angle `line_rad` in the axes of line's body. One equation.
/// Two slots on one line make a prismatic joint.
struct Slot {
  BodyPoint point;
  BodyPoint line;
  double line_rad = 0.0;
};

/// A list of at most `Most` items that lies where it is declared, because the haptic thread does not allocate.
template <class Item, int Most>
class ShortList {
 public:
  ShortList() = default;
  ShortList(std::initializer_list<Item> items) {
    for (const Item& item : items) push_back(item);
  }
  void push_back(const Item& item) {
    demand(count_ < Most, "a mechanism has no more joints than its list holds");
    items_[static_cast<std::size_t>(count_++)] = item;
  }
  void pop_back() noexcept { count_ -= count_ > 0 ? 1 : 0; }
  [[nodiscard]] int size() const noexcept { return count_; }
  [[nodiscard]] Item& operator[](int i) noexcept { return items_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Item* begin() const noexcept { return items_.data(); }
  [[nodiscard]] const Item* end() const noexcept { return items_.data() + count_; }

 private:
  std::array<Item, Most> items_{};
  int count_ = 0;
};

/// A planar mechanism with a needle and a place where the hand holds it, described by bodies and joints. It includes
/// five-bar and six-bar linkages, which S4 names as a gap.
struct PlanarMechanism {
  int bodies = 0;
  ShortList<Pin, kMostEquations / 2> pins;
  ShortList<Slot, kMostBodies> slots;
  BodyPoint grasp;  ///< where the hand is
  BodyPoint tip;    ///< tip of the needle
};

/// x, y [m] and angle [rad] of each moving body.
using PlanarPose = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostCoordinates, 1>;
using PlanarRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostEquations, kMostCoordinates>;
using PlanarErrors = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostEquations, 1>;

/// A hand that holds a planar mechanism of one or two degrees of freedom. The mechanism takes the pose in which the
/// held point is nearest to the hand: for a four-bar linkage this is S4's rotation by the angle GOT. The search
/// begins at the previous pose, so the branch is kept; a step that would pass a dead point stops before it. Pure: no
/// allocation after the constructor. Owner: the thread that calls step().
class HeldMechanism {
 public:
  /// `pose` closes all joints (assembled() of planar_designs.h); the mechanism has one or two degrees of freedom.
  HeldMechanism(const PlanarMechanism& mechanism, const PlanarPose& pose, double most_gain = 5.0) noexcept;

  /// Moves the mechanism to the hand at `hand_m` [m, in the frame's axes]. A hand that is not finite leaves it as it
  /// is.
  void step(const Eigen::Vector2d& hand_m) noexcept;
  /// The hand holds the mechanism at `point` from now on. The pose stays.
  void hold_at(const BodyPoint& point) noexcept;
  /// Takes other lengths for the same bodies and joints, and closes the joints again from the pose as it is. False:
  /// they do not close without passing a dead point, and nothing has changed.
  [[nodiscard]] bool change(const PlanarMechanism& mechanism) noexcept;

  [[nodiscard]] const PlanarMechanism& mechanism() const noexcept { return mechanism_; }
  [[nodiscard]] const PlanarPose& pose() const noexcept { return pose_; }
  [[nodiscard]] Eigen::Vector2d grasp_m() const noexcept;
  [[nodiscard]] Eigen::Vector2d tip_m() const noexcept;
  /// Where a point of a body is [m, in the frame's axes].
  [[nodiscard]] Eigen::Vector2d where_m(const BodyPoint& point) const noexcept;
  /// Largest distance by which a joint is open [m].
  [[nodiscard]] double open_m() const noexcept;
  [[nodiscard]] int freedoms() const noexcept { return static_cast<int>(free_.cols()); }

  /// Force on the hand [N] of the force `at_tip_N` on the needle's tip, by virtual work over all motions that the
  /// joints allow. Exact while the gain is at most `most_gain`; nearer to a dead point it stays at that gain.
  [[nodiscard]] Eigen::Vector2d hand_force_N(const Eigen::Vector2d& at_tip_N) const noexcept;

 private:
  using Freedoms = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostCoordinates, kMostCoordinates>;
  using Motion = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMostCoordinates>;
  struct Linear;
  [[nodiscard]] Linear linear_at(const PlanarPose& pose) const noexcept;
  [[nodiscard]] bool improve(const Eigen::Vector2d& hand_m) noexcept;
  [[nodiscard]] bool passes_dead_point(const Linear& next) const noexcept;
  void adopt(const PlanarPose& pose, const Linear& linear) noexcept;

  PlanarMechanism mechanism_;
  double most_gain_;
  PlanarPose pose_;
  Freedoms free_;                                        // motions that the joints allow, one in each column
  Motion grasp_motion_;                                  // motion of the held point, for each column of free_
  Motion tip_motion_;                                    // motion of the tip, for each column of free_
  Eigen::Vector2d last_way_ = Eigen::Vector2d::UnitX();  // direction in which the held point could move last
};

}  // namespace telepalp::mechanism
