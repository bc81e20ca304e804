#include "haptic_station/solids/walls.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/solids/shapes/evaluate.h"
#include "haptic_station/solids/shapes/shapes.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

/// A node's frame, and the frames around it up to the tree's.
struct Frame {
  const TreeNode* node;
  const Frame* around;
};

/// A point in one of these frames. `unit_m`: metres of the tree's frame in one unit of this frame. `side`: 1, or -1
/// where the node is cut away from a solid, so that its inside is free. `more_m`: what the tree's value is above side
/// times the node's, in metres.
struct Spot {
  Vector3d p;
  double unit_m = 1.0;
  const Frame* frame = nullptr;
  double side = 1.0;
  double more_m = 0.0;

  [[nodiscard]] bool cut_away() const noexcept { return side < 0.0; }
};

/// The spot in the own frame of the frame's node.
Spot inside(const Frame& frame, Spot spot) noexcept {
  if (!frame.node->placed) return spot;
  spot.p = in_frame_of(*frame.node, spot.p);
  spot.unit_m *= frame.node->scale;
  spot.frame = &frame;
  return spot;
}

class WallSearch {
 public:
  WallSearch(const SolidTree& tree, const Vector3d& p, double swell_m, Walls& walls) noexcept
      : tree_(tree), at_(p), near_m_(tree.steepest * Walls::kNear_m + swell_m), walls_(walls) {}

  /// The walls of node `index`. `around`: in the frame of the operator that contains the node.
  void search(std::uint32_t index, const Spot& around) noexcept {
    const TreeNode& node = tree_.nodes[index];
    const double near = near_m_ / around.unit_m;
    if (!around.cut_away() && node.box.squared_distance_m2(around.p) > near * near) return;
    const Frame frame{&node, around.frame};
    visit(node, index, inside(frame, around));
  }

 private:
  void visit(const TreeNode& node, std::uint32_t index, const Spot& spot) noexcept {
    switch (node.op) {
      case Op::Union:
        return spot.cut_away() ? deepest_member(node, index, spot) : all_members(node, spot);
      case Op::Intersection:
        return intersection(node, spot);
      case Op::Difference:
        return difference(node, spot);
      case Op::Clip:
        return clip(node, index, spot);
      case Op::Box:
        return spot.cut_away() ? room(node, index, spot) : smooth(index, spot);
      case Op::Cylinder:
        return spot.cut_away() ? drum(node, index, spot) : smooth(index, spot);
      default:
        return smooth(index, spot);
    }
  }

  /// The one wall of a blend, or of a shape that is smooth on this side.
  void smooth(std::uint32_t index, const Spot& spot) noexcept { offer(spot, own_value(tree_, index, spot.p)); }

  void all_members(const TreeNode& node, const Spot& spot) noexcept {
    for (std::uint32_t i = node.first; i < node.second; ++i) search(tree_.loose[i], spot);
    if (node.hierarchy == kNothing) return;
    for_each_near(tree_, node.hierarchy, spot.p, near_m_ / spot.unit_m, [&](std::uint32_t member) {
      search(member, spot);
      return true;
    });
  }

  /// Of several solids that are cut away, the one in which the point is deepest has the nearest wall.
  void deepest_member(const TreeNode& node, std::uint32_t index, const Spot& spot) noexcept {
    std::uint32_t deepest = kNothing;
    double least = HUGE_VAL;
    const auto take = [&](std::uint32_t member) {
      const double value = evaluate(tree_, member, spot.p).m;
      if (value < least) deepest = member;
      least = std::min(least, value);
      return true;
    };
    for (std::uint32_t i = node.first; i < node.second; ++i) take(tree_.loose[i]);
    if (node.hierarchy != kNothing) for_each_near(tree_, node.hierarchy, spot.p, near_m_ / spot.unit_m, take);
    if (deepest == kNothing) return smooth(index, spot);
    search(deepest, spot);
  }

  // Of an intersection, a difference or a clip, the part with the greater value is the wall. If the node itself is cut
  // away, the walls of both parts count.

  void intersection(const TreeNode& node, const Spot& spot) noexcept {
    const bool first = evaluate(tree_, node.first, spot.p).m >= evaluate(tree_, node.second, spot.p).m;
    if (spot.cut_away() || first) search(node.first, spot);
    if (spot.cut_away() || !first) search(node.second, spot);
  }

  void difference(const TreeNode& node, const Spot& spot) noexcept {
    Spot cut = spot;
    cut.side = -spot.side;
    cut.more_m += spot.side * kSeam_m;
    const bool kept = evaluate(tree_, node.first, spot.p).m >= cut_value(tree_, node, spot.p).m;
    if (spot.cut_away() || kept) search(node.first, spot);
    if (spot.cut_away() || !kept) search(node.second, cut);
  }

  void clip(const TreeNode& node, std::uint32_t index, const Spot& spot) noexcept {
    const ShapeAt plane = plane_at(spot.p, {node.numbers[0], node.numbers[1], node.numbers[2]}, node.numbers[3]);
    const bool kept = evaluate(tree_, node.first, spot.p).m >= plane.m;
    if (spot.cut_away() || kept) search(node.first, spot);
    if (spot.cut_away() || !kept) offer(spot, {plane.m, plane.gradient, index});
  }

  /// The six walls of a box, seen from inside.
  void room(const TreeNode& node, std::uint32_t index, const Spot& spot) noexcept {
    for (int axis = 0; axis < 3; ++axis) ends(axis, node.numbers[static_cast<std::size_t>(axis)], index, spot);
  }

  /// The curved wall and the two ends of a cylinder, seen from inside.
  void drum(const TreeNode& node, std::uint32_t index, const Spot& spot) noexcept {
    Vector3d from_axis = spot.p;
    from_axis[node.axis] = 0.0;
    const double radius = from_axis.norm();
    if (radius > 0.0) offer(spot, {radius - node.numbers[0], from_axis / radius, index});
    ends(node.axis, node.numbers[1], index, spot);
  }

  void ends(int axis, double half, std::uint32_t index, const Spot& spot) noexcept {
    for (const double end : {-1.0, 1.0}) offer(spot, {end * spot.p[axis] - half, end * Vector3d::Unit(axis), index});
  }

  void offer(const Spot& spot, const SolidAt& own) noexcept {
    const double m = spot.side * own.m * spot.unit_m + spot.more_m;
    if (m > tree_.steepest * Walls::kNear_m) return;
    Vector3d gradient = spot.side * own.gradient;
    for (const Frame* frame = spot.frame; frame != nullptr; frame = frame->around)
      if (frame->node->turned) gradient = frame->node->turn * gradient;
    walls_.offer(at_, m, gradient);
  }

  const SolidTree& tree_;
  const Vector3d& at_;
  double near_m_;
  Walls& walls_;
};

}  // namespace

void Walls::offer(const Vector3d& p, double m, const Vector3d& gradient) noexcept {
  least_m = std::min(least_m, m);
  const double length = gradient.norm();
  if (!(length >= kShortest)) return;
  std::size_t place = count;
  if (count == kMost) {
    place = static_cast<std::size_t>(std::max_element(values_m_.begin(), values_m_.end()) - values_m_.begin());
    if (m >= values_m_[place]) return;
  } else {
    ++count;
  }
  const Vector3d normal = gradient / length;
  spaces_[place] = {normal, normal.dot(p) - m / length};
  values_m_[place] = m;
}

Walls walls_at(const SolidTree& tree, const Vector3d& p, double swell_m) noexcept {
  Walls walls;
  if (!tree.nodes.empty()) WallSearch(tree, p, swell_m, walls).search(tree.root, {.p = p, .more_m = -swell_m});
  return walls;
}

Walls walls_of(const SolidTree& tree, std::span<const std::uint32_t> members, const Vector3d& p,
               double swell_m) noexcept {
  Walls walls;
  WallSearch search(tree, p, swell_m, walls);
  const Frame frame{&tree.nodes[tree.root], nullptr};
  const Spot spot = inside(frame, {.p = p, .more_m = -swell_m});
  for (const std::uint32_t member : members) search.search(member, spot);
  return walls;
}

}  // namespace telepalp::solids
