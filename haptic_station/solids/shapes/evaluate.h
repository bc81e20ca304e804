#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// Value and gradient of node `index` at `p`, both in the frame of the operator that contains the node.
[[nodiscard]] SolidAt evaluate(const SolidTree& tree, std::uint32_t index, const Eigen::Vector3d& p) noexcept;

/// The same in the node's own frame.
[[nodiscard]] SolidAt own_value(const SolidTree& tree, std::uint32_t index, const Eigen::Vector3d& p) noexcept;

/// Of a difference, value and gradient of what is cut away, negated; in the difference's own frame.
[[nodiscard]] SolidAt cut_value(const SolidTree& tree, const TreeNode& difference, const Eigen::Vector3d& p) noexcept;

/// Converts a value and gradient from a node's own frame to the frame of the operator that contains the node.
[[nodiscard]] inline SolidAt placed(const TreeNode& node, SolidAt at) noexcept {
  at.m *= node.scale;
  if (node.turned) at.gradient = node.turn * at.gradient;
  return at;
}

/// Converts a point from the frame of the operator that contains the node to the node's own frame.
[[nodiscard]] inline Eigen::Vector3d in_frame_of(const TreeNode& node, const Eigen::Vector3d& p) noexcept {
  if (!node.placed) return p;
  const Eigen::Vector3d moved = (p - node.shift) / node.scale;
  return node.turned ? Eigen::Vector3d(node.turn.transpose() * moved) : moved;
}

/// `at`, or the distance from `p` to the node's box, with its gradient, if this distance is greater. An operator's
/// value may be a mere lower bound of the distance; this function raises it to at least the distance to the node's box.
/// So a part whose box is farther away than the least value so far can be skipped without a change of the result.
[[nodiscard]] SolidAt at_least_the_box(const TreeNode& node, const Eigen::Vector3d& p, const SolidAt& at) noexcept;

using Lanes = std::array<double, BoxNode::kWidth>;

/// Squared distances from `p` to the boxes of the node's children [m^2], one lane per child, so that the compiler can
/// vectorise.
[[nodiscard]] inline Lanes squared_distances(const BoxNode& node, const Eigen::Vector3d& p) noexcept {
  Lanes sum{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = p[static_cast<Eigen::Index>(axis)];
    for (std::size_t i = 0; i < BoxNode::kWidth; ++i) {
      const double gap = std::max(std::max(double{node.low[axis][i]} - at, at - double{node.high[axis][i]}), 0.0);
      sum[i] += gap * gap;
    }
  }
  return sum;
}

/// Calls `take` with each bounded member whose box is at most `within` away, until it returns false.
template <class Take>
bool for_each_near(const SolidTree& tree, std::uint32_t box, const Eigen::Vector3d& p, double within,
                   Take&& take) noexcept {
  const BoxNode& node = tree.boxes[box];
  const Lanes squared = squared_distances(node, p);
  for (std::size_t i = 0; i < BoxNode::kWidth; ++i) {
    const std::uint32_t child = node.child[i];
    if (child == kNothing || squared[i] > within * within) continue;
    const bool goes_on =
        (child & BoxNode::kMember) != 0 ? take(child & ~BoxNode::kMember) : for_each_near(tree, child, p, within, take);
    if (!goes_on) return false;
  }
  return true;
}

/// The least of the values taken so far; on an exact tie, with the mean of their gradients.
class Least {
 public:
  explicit Least(std::uint32_t part) noexcept
      : best_{std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero(), part} {}

  void take(const SolidAt& at) noexcept {
    if (at.m > best_.m) return;
    const bool tie = at.m == best_.m && ties_ > 0;
    best_ = tie ? SolidAt{at.m, best_.gradient + at.gradient, std::min(at.part, best_.part)} : at;
    ties_ = tie ? ties_ + 1 : 1;
  }
  /// True when a part whose box is at this squared distance cannot have a value as low as the least so far.
  [[nodiscard]] bool beats(double squared_m2) const noexcept {
    return best_.m < 0.0 ? squared_m2 > 0.0 : squared_m2 > best_.m * best_.m;
  }
  [[nodiscard]] SolidAt result() const noexcept {
    return ties_ > 1 ? SolidAt{best_.m, best_.gradient / ties_, best_.part} : best_;
  }

 private:
  SolidAt best_;
  int ties_ = 0;
};

}  // namespace telepalp::solids
