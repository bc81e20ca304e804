#include "haptic_station/solids/near_members.h"

#include <cmath>

#include "haptic_station/solids/shapes/evaluate.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

bool is_union(const SolidTree& tree) noexcept { return !tree.nodes.empty() && tree.nodes[tree.root].op == Op::Union; }

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
  const double change_m = tree.steepest * (2.0 * kReach_m + Walls::kNear_m);
  const double most_m = (std::max(solid_at(tree, point_m).m, 0.0) + change_m) / root.scale;
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

std::span<const std::uint32_t> NearMembers::members_at(const SolidTree& tree, const Vector3d& point_m) noexcept {
  if (!is_union(tree) || !point_m.allFinite()) return {};
  if (!covers(tree, point_m)) gather(tree, point_m);
  return {members_.data(), count_};
}

Walls NearMembers::walls(const SolidTree& tree, const Vector3d& point_m, double swell_m) noexcept {
  const std::span members = members_at(tree, point_m);
  return members.empty() ? walls_at(tree, point_m, swell_m) : walls_of(tree, members, point_m, swell_m);
}

SolidAt NearMembers::at(const SolidTree& tree, const Vector3d& point_m) noexcept {
  const std::span members = members_at(tree, point_m);
  if (members.empty()) return solid_at(tree, point_m);
  const TreeNode& root = tree.nodes[tree.root];
  const Vector3d p = in_frame_of(root, point_m);
  Least least(tree.root);
  for (const std::uint32_t member : members) least.take(evaluate(tree, member, p));
  const SolidAt at = placed(root, least.result());
  return root.exactness == Exactness::Bound ? at_least_the_box(root, point_m, at) : at;
}

}  // namespace telepalp::solids
