#include <algorithm>
#include <cmath>

#include "haptic_station/solids/shapes/evaluate.h"
#include "haptic_station/solids/shapes/shapes.h"
#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

SolidAt of_shape(const ShapeAt& at, std::uint32_t part) noexcept { return {at.m, at.gradient, part}; }

Vector3d three(const TreeNode& node, std::size_t first) noexcept {
  return {node.numbers[first], node.numbers[first + 1], node.numbers[first + 2]};
}

/// Of two values the greater one; a tie gives the mean gradient.
SolidAt greater(const SolidAt& a, const SolidAt& b) noexcept {
  if (a.m != b.m) return a.m > b.m ? a : b;
  return {a.m, 0.5 * (a.gradient + b.gradient), std::min(a.part, b.part)};
}

struct Waiting {
  std::uint32_t node;
  double squared_m2;
};
constexpr std::size_t kMostWaiting =
    64;  // at most 16 levels of 4 children: each leaves 3 boxes waiting, the last one 4

/// Prefetches the two cache lines that a visit of the child reads, while the other children are tested: with 10 000
/// solids, waiting for these lines takes most of the time.
void prefetch(const SolidTree& tree, std::uint32_t child) noexcept {
  if ((child & BoxNode::kMember) != 0) {
    const TreeNode& member = tree.nodes[child & ~BoxNode::kMember];
    __builtin_prefetch(&member);
    __builtin_prefetch(&member.numbers.back());
  } else {
    const BoxNode& box = tree.boxes[child];
    __builtin_prefetch(&box);
    __builtin_prefetch(&box.child);
  }
}

/// Visits the nearest box first, so that its value rules out boxes that are farther away.
void evaluate_bounded(const SolidTree& tree, std::uint32_t hierarchy, const Vector3d& p, Least& least) noexcept {
  std::array<Waiting, kMostWaiting> waiting;
  std::size_t count = 0;
  waiting[count++] = {hierarchy, 0.0};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (least.beats(next.squared_m2)) continue;
    if ((next.node & BoxNode::kMember) != 0) {
      least.take(evaluate(tree, next.node & ~BoxNode::kMember, p));
      continue;
    }
    const BoxNode& node = tree.boxes[next.node];
    const Lanes squared_m2 = squared_distances(node, p);
    const std::size_t first = count;
    for (std::size_t i = 0; i < BoxNode::kWidth; ++i) {
      if (node.child[i] == kNothing || least.beats(squared_m2[i])) continue;
      prefetch(tree, node.child[i]);
      std::size_t place = count++;
      for (; place > first && waiting[place - 1].squared_m2 < squared_m2[i]; --place)
        waiting[place] = waiting[place - 1];
      waiting[place] = {node.child[i], squared_m2[i]};
    }
  }
}

SolidAt union_at(const SolidTree& tree, std::uint32_t index, const Vector3d& p) noexcept {
  const TreeNode& node = tree.nodes[index];
  Least least(index);
  for (std::uint32_t i = node.first; i < node.second; ++i) least.take(evaluate(tree, tree.loose[i], p));
  if (node.hierarchy != kNothing) evaluate_bounded(tree, node.hierarchy, p, least);
  return least.result();
}

SolidAt difference_at(const SolidTree& tree, const TreeNode& node, const Vector3d& p) noexcept {
  const SolidAt kept = evaluate(tree, node.first, p);
  const double squared_m2 = tree.nodes[node.second].box.squared_distance_m2(p);
  if (squared_m2 > 0.0 && kept.m > node.numbers[0] - std::sqrt(squared_m2)) return kept;
  return greater(kept, cut_value(tree, node, p));
}

SolidAt blend_at(const SolidTree& tree, std::uint32_t index, const Vector3d& p) noexcept {
  const TreeNode& node = tree.nodes[index];
  const double width_m = node.numbers[0];
  const SolidAt a = evaluate(tree, node.first, p);
  if (const double reach_m = a.m + width_m;
      reach_m <= 0.0 ? false : tree.nodes[node.second].box.squared_distance_m2(p) > reach_m * reach_m)
    return a;
  const SolidAt b = evaluate(tree, node.second, p);
  const double share = std::max(0.0, width_m - std::abs(a.m - b.m)) / width_m;
  const SolidAt& lower = a.m <= b.m ? a : b;
  if (share <= 0.0) return lower;
  const SolidAt& upper = a.m <= b.m ? b : a;
  return {lower.m - 0.25 * width_m * share * share, (1.0 - 0.5 * share) * lower.gradient + 0.5 * share * upper.gradient,
          index};
}

SolidAt operator_at(const SolidTree& tree, std::uint32_t index, const Vector3d& p) noexcept {
  const TreeNode& node = tree.nodes[index];
  switch (node.op) {
    case Op::Union:
      return union_at(tree, index, p);
    case Op::Intersection:
      return greater(evaluate(tree, node.first, p), evaluate(tree, node.second, p));
    case Op::Difference:
      return difference_at(tree, node, p);
    case Op::Blend:
      return blend_at(tree, index, p);
    case Op::Clip:
      return greater(evaluate(tree, node.first, p), of_shape(plane_at(p, three(node, 0), node.numbers[3]), index));
    default:
      return evaluate(tree, node.first, p);  // a placement: build_tree() has folded it into the node
  }
}

}  // namespace

SolidAt own_value(const SolidTree& tree, std::uint32_t index, const Vector3d& p) noexcept {
  const TreeNode& node = tree.nodes[index];
  const auto& n = node.numbers;
  switch (node.op) {
    case Op::Sphere:
      return of_shape(sphere_at(p, n[0]), index);
    case Op::Plane:
      return of_shape(plane_at(p, three(node, 0), n[3]), index);
    case Op::Capsule:
      return of_shape(capsule_at(p, three(node, 0), three(node, 3), n[6]), index);
    case Op::Torus:
      return of_shape(torus_at(p, node.axis, n[0], n[1]), index);
    case Op::Arc:
      return of_shape(arc_at(p, node.axis, n[0], n[1], {n[2], n[3]}), index);
    case Op::Box:
      return of_shape(box_at(p, three(node, 0)), index);
    case Op::Ellipsoid:
      return of_shape(ellipsoid_at(p, three(node, 0)), index);
    case Op::Cylinder:
      return of_shape(cylinder_at(p, node.axis, n[0], n[1]), index);
    case Op::Mesh:
      return of_shape(mesh_at(p, *node.lattice), index);
    default:
      return operator_at(tree, index, p);
  }
}

SolidAt cut_value(const SolidTree& tree, const TreeNode& difference, const Vector3d& p) noexcept {
  const SolidAt cut = evaluate(tree, difference.second, p);
  return {difference.numbers[0] - cut.m, -cut.gradient, cut.part};
}

SolidAt at_least_the_box(const TreeNode& node, const Vector3d& p, const SolidAt& at) noexcept {
  const double squared_m2 = node.box.squared_distance_m2(p);
  if (!(squared_m2 > 0.0) || (at.m > 0.0 && at.m * at.m >= squared_m2)) return at;
  const double distance_m = std::sqrt(squared_m2);
  const Vector3d gap = p - p.cwiseMax(node.box.low).cwiseMin(node.box.high);
  return {distance_m, gap / distance_m, kNothing};
}

SolidAt evaluate(const SolidTree& tree, std::uint32_t index, const Vector3d& p) noexcept {
  const TreeNode& node = tree.nodes[index];
  const SolidAt own = own_value(tree, index, in_frame_of(node, p));
  const SolidAt at = node.placed ? placed(node, own) : own;
  return node.exactness == Exactness::Bound ? at_least_the_box(node, p, at) : at;
}

SolidAt solid_at(const SolidTree& tree, const Vector3d& point_m) noexcept {
  if (tree.nodes.empty() || !point_m.allFinite())
    return {std::numeric_limits<double>::infinity(), Vector3d::Zero(), kNothing};
  return evaluate(tree, tree.root, point_m);
}

}  // namespace telepalp::solids
