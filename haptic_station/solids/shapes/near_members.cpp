#include "haptic_station/solids/near_members.h"

#include <cmath>

#include "haptic_station/solids/shapes/evaluate.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

bool is_union(const SolidTree& tree) noexcept { return !tree.nodes.empty() && tree.nodes[tree.root].op == Op::Union; }

/// Calls `take` with each bounded member whose box is at most `within_m` away, until it returns false.
template <class Take>
bool for_each_near(const SolidTree& tree, std::uint32_t box, const Vector3d& p, double within_m, Take&& take) noexcept {
  const BoxNode& node = tree.boxes[box];
  const Lanes squared_m2 = squared_distances(node, p);
  for (std::size_t i = 0; i < BoxNode::kWidth; ++i) {
    const std::uint32_t child = node.child[i];
    if (child == kNothing || squared_m2[i] > within_m * within_m) continue;
    const bool goes_on = (child & BoxNode::kMember) != 0 ? take(child & ~BoxNode::kMember)
                                                         : for_each_near(tree, child, p, within_m, take);
    if (!goes_on) return false;
  }
  return true;
}

}  // namespace

bool NearMembers::covers(const SolidTree& tree, const Vector3d& point_m) const noexcept {
  return tree_ == &tree && (point_m - middle_).squaredNorm() <= kReach_m * kReach_m;
}

void NearMembers::gather(const SolidTree& tree, const Vector3d& point_m) noexcept {
  tree_ = &tree;
  middle_ = point_m;
  count_ = 0;
  const TreeNode& root = tree.nodes[tree.root];
  const Vector3d p = in_frame_of(root, point_m);
  // In the root's own frame, lengths and values are both divided by its scale, so the greatest slope is the same.
  const double most_m = solid_at(tree, point_m).m / root.scale + 2.0 * tree.steepest * kReach_m / root.scale;
  const auto take = [&](std::uint32_t member) {
    if (evaluate(tree, member, p).m > most_m) return true;
    if (count_ == kMost) return false;
    members_[count_++] = member;
    return true;
  };
  bool room = std::isfinite(most_m);
  for (std::uint32_t i = root.first; room && i < root.second; ++i) room = take(tree.loose[i]);
  if (room && root.hierarchy != kNothing) room = for_each_near(tree, root.hierarchy, p, std::max(most_m, 0.0), take);
  if (!room) count_ = 0;
}

SolidAt NearMembers::at(const SolidTree& tree, const Vector3d& point_m) noexcept {
  if (!is_union(tree) || !point_m.allFinite()) return solid_at(tree, point_m);
  if (!covers(tree, point_m)) gather(tree, point_m);
  if (count_ == 0) return solid_at(tree, point_m);
  const TreeNode& root = tree.nodes[tree.root];
  const Vector3d p = in_frame_of(root, point_m);
  Least least(tree.root);
  for (std::size_t i = 0; i < count_; ++i) least.take(evaluate(tree, members_[i], p));
  const SolidAt at = placed(root, least.result());
  return root.exactness == Exactness::Bound ? at_least_the_box(root, point_m, at) : at;
}

}  // namespace telepalp::solids
