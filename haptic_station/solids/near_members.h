#pragma once

#include <array>

#include "haptic_station/solids/solid_tree.h"
#include "haptic_station/solids/walls.h"

namespace telepalp::solids {

/// Remembers which members of a tree's outermost union can give the union's value within kReach_m of a centre point, so
/// that only these members are evaluated for a finger that moves slowly. A member's value changes by at most
/// SolidTree::steepest per metre: a member whose value at the centre exceeds the least value, or 0, by more than
/// steepest (2 kReach_m + Walls::kNear_m) cannot become the least, or a near wall, within kReach_m. The value equals
/// that of solid_at(); on an exact tie the gradient may differ by rounding. If the root is not a union, or more than
/// kMost members can give the value, solid_at() evaluates the tree. Owner: the haptic thread. Nothing allocates.
class NearMembers {
 public:
  static constexpr double kReach_m = 0.003;  ///< a finger at 0.1 m/s moves this far in 30 ms
  static constexpr std::size_t kMost = 12;

  /// Value and gradient at a point, in the solid's frame. Members are gathered anew for another tree or a far point.
  [[nodiscard]] SolidAt at(const SolidTree& tree, const Eigen::Vector3d& point_m) noexcept;

  /// The walls near a point that is on the surface or near it, as walls_at() gives them.
  [[nodiscard]] Walls walls(const SolidTree& tree, const Eigen::Vector3d& point_m, double swell_m) noexcept;

 private:
  /// The members to evaluate at a point; empty: evaluate the whole tree.
  [[nodiscard]] std::span<const std::uint32_t> members_at(const SolidTree& tree,
                                                          const Eigen::Vector3d& point_m) noexcept;
  [[nodiscard]] bool covers(const SolidTree& tree, const Eigen::Vector3d& point_m) const noexcept;
  void gather(const SolidTree& tree, const Eigen::Vector3d& point_m) noexcept;

  const SolidTree* tree_ = nullptr;  // borrowed; only its address is compared
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  std::array<std::uint32_t, kMost> members_{};
  std::size_t count_ = 0;  // 0: no members gathered, or more than kMost
};

}  // namespace telepalp::solids
