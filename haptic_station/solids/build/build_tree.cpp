#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptic_station/solids/build/box_hierarchy.h"
#include "haptic_station/solids/build/shape_box.h"
#include "haptic_station/solids/solid_tree.h"
#include "proto/words/error_line.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

constexpr double kRadians = std::numbers::pi / 180.0;

Vector3d three(const Node& node, std::size_t first) {
  return {node.numbers[first], node.numbers[first + 1], node.numbers[first + 2]};
}

bool is_placement(Op op) noexcept {
  return op == Op::Translate || op == Op::Transform || op == Op::Rotate || op == Op::Scale;
}

/// A placement: p_above = scale turn p + shift, with p in the node's own frame and p_above in the frame above.
struct Placing {
  double scale = 1.0;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vector3d shift = Vector3d::Zero();

  /// The placement that applies `inner` first and then this one.
  [[nodiscard]] Placing after(const Placing& inner) const {
    return {scale * inner.scale, turn * inner.turn, scale * (turn * inner.shift) + shift};
  }
};

Placing placing_of(const Node& node) {
  Placing placing;
  const Op op = node.kind().op;
  if (op == Op::Translate || op == Op::Transform) placing.shift = three(node, 0);
  if (op == Op::Scale) placing.scale = node.numbers[0];
  const std::size_t turn = op == Op::Transform ? 3 : 0;
  if (op == Op::Rotate || op == Op::Transform)
    placing.turn =
        Eigen::AngleAxisd(node.numbers[turn] * kRadians, three(node, turn + 1).normalized()).toRotationMatrix();
  return placing;
}

/// The node's numbers as TreeNode needs them: the normal of a plane or clip has length 1; an arc has its middle angle
/// and half of its sweep, in radians, instead of its ends in degrees.
std::array<double, 8> numbers_of(const Node& node) {
  std::array<double, 8> numbers{};
  std::copy(node.numbers.begin(), node.numbers.end(), numbers.begin());
  if (node.kind().op == Op::Plane || node.kind().op == Op::Clip) {
    const double length = three(node, 0).norm();
    for (std::size_t i = 0; i < 4; ++i) numbers[i] /= length;
  }
  if (node.kind().op == Op::Arc) {
    numbers[2] = 0.5 * (node.numbers[2] + node.numbers[3]) * kRadians;
    numbers[3] = 0.5 * (node.numbers[3] - node.numbers[2]) * kRadians;
  }
  return numbers;
}

/// Copies a description into a tree. The description has been checked.
class TreeBuilder {
 public:
  explicit TreeBuilder(const Solid& solid) : solid_(solid) {}

  SolidTree build() {
    tree_.root = add(0, 1.0);
    return std::move(tree_);
  }

 private:
  /// `unit_m`: metres of the tree's frame in one unit of the frame around the node.
  std::uint32_t add(std::size_t at, double unit_m) {
    Placing placing;
    bool placed = false;
    for (; is_placement(solid_[at].kind().op); ++at) {
      placing = placing.after(placing_of(solid_[at]));
      placed = true;
    }
    const Node& given = solid_[at];
    TreeNode node;
    node.op = given.kind().op;
    node.axis = static_cast<std::uint8_t>(given.kind().axis);
    node.placed = placed;
    node.numbers = numbers_of(given);
    node.scale = placing.scale;
    node.turn = placing.turn;
    node.turned = !placing.turn.isIdentity(0.0);
    node.shift = placing.shift;
    if (given.kind().operands == 0)
      add_shape(given, node);
    else if (node.op == Op::Union)
      add_union(at, node, unit_m * placing.scale);
    else
      add_operator(at, node, unit_m * placing.scale);
    if (placed) node.box = placed_box(node.box, node);
    tree_.nodes.push_back(node);
    return static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  }

  void add_shape(const Node& given, TreeNode& node) {
    ++tree_.shapes;
    if (given.lattice) {
      tree_.lattices.push_back(given.lattice);
      node.lattice = given.lattice.get();
      node.exactness = Exactness::Bound;
      tree_.steepest = std::sqrt(3.0);
    }
    if (node.op == Op::Arc) node.exactness = Exactness::Outside;
    node.box = shape_box(node);
  }

  /// The members of a union and of the unions that are its operands.
  void gather(std::size_t at, double unit_m, std::vector<std::uint32_t>& members) {
    while (solid_[at].kind().op == Op::Union) {
      gather(at + 1, unit_m, members);
      at = end_of(solid_, at + 1);
    }
    members.push_back(add(at, unit_m));
  }

  void add_union(std::size_t at, TreeNode& node, double unit_m) {
    std::vector<std::uint32_t> members;
    gather(at, unit_m, members);
    const auto bounded = std::stable_partition(
        members.begin(), members.end(), [&](std::uint32_t member) { return !tree_.nodes[member].box.bounded(); });
    node.first = static_cast<std::uint32_t>(tree_.loose.size());
    tree_.loose.insert(tree_.loose.end(), members.begin(), bounded);
    node.second = static_cast<std::uint32_t>(tree_.loose.size());
    node.hierarchy = add_hierarchy(tree_, {bounded, members.end()});
    node.exactness = Exactness::Outside;
    for (const std::uint32_t member : members)
      if (tree_.nodes[member].exactness == Exactness::Bound) node.exactness = Exactness::Bound;
    node.box = tree_.nodes[members.front()].box;
    for (const std::uint32_t member : members) node.box = joined(node.box, tree_.nodes[member].box);
  }

  void add_operator(std::size_t at, TreeNode& node, double unit_m) {
    node.exactness = Exactness::Bound;
    node.first = add(at + 1, unit_m);
    const Box first = tree_.nodes[node.first].box;
    if (node.op == Op::Clip) {
      node.box = clipped(first, {node.numbers[0], node.numbers[1], node.numbers[2]}, node.numbers[3]);
      return;
    }
    node.second = add(end_of(solid_, at + 1), unit_m);
    const Box& second = tree_.nodes[node.second].box;
    if (node.op == Op::Intersection) node.box = common(first, second);
    if (node.op == Op::Difference) {
      node.box = first;
      node.numbers[0] = kSeam_m / unit_m;
    }
    if (node.op == Op::Blend) node.box = widened(joined(first, second), 0.25 * node.numbers[0]);
  }

  const Solid& solid_;
  SolidTree tree_;
};

Error wrong(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "solid", .fix = std::move(fix)};
}

/// The level of each operand, as kMostNesting counts it; an error when the nodes are not one whole solid.
Result<void> check(const Solid& solid) {
  if (solid.size() > kMostNodes)
    return wrong("the solid has " + std::to_string(solid.size()) + " nodes (shapes and operators)",
                 "give at most 200000");
  std::vector<int> levels{0};  // of the operands that are still missing; the next one is last
  for (const Node& node : solid) {
    if (levels.empty())
      return wrong("more shapes or operators follow after the end of the solid", "join solids by a union");
    const int level = levels.back();
    levels.pop_back();
    if (level > kMostNesting)
      return wrong(
          "operators nest deeper than " + std::to_string(kMostNesting) + " levels",
          "join the solids by unions, each the last operand of the one before: such a chain of unions does not nest");
    if (const auto complaint = complaint_about(node)) return wrong(complaint->what, complaint->fix);
    if (node.kind().op == Op::Mesh && !node.lattice)
      return wrong("the mesh \"" + node.file + "\" of the solid is not loaded",
                   "this is a defect of telepalp: report it, with the scene file");
    const bool chain = node.kind().op == Op::Union;
    for (int i = 0; i < node.kind().operands; ++i) levels.push_back(chain && i == 0 ? level : level + 1);
  }
  if (!levels.empty())
    return wrong("an operator, such as union or clip, lacks a solid", "write the solids of each operator after it");
  return {};
}

/// Nested scales can multiply to a value that no double holds, although each factor is within its range.
Result<void> check_values(const SolidTree& tree) {
  constexpr double kAround_m[] = {-1.0, 0.0, 1.0};
  std::vector<Vector3d> points;
  for (const double x : kAround_m)
    for (const double y : kAround_m)
      for (const double z : kAround_m) points.emplace_back(x, y, z);
  if (const Box& box = tree.box(); box.bounded()) points.push_back(0.5 * (box.low + box.high));
  for (const Vector3d& p : points) {
    const SolidAt at = solid_at(tree, p);
    if (std::isfinite(at.m) && at.gradient.allFinite()) continue;
    return wrong("the solid has no finite value near (" + number_text(p.x()) + ", " + number_text(p.y()) + ", " +
                     number_text(p.z()) + ")",
                 "check its numbers: nested scales multiply, and a description in metres needs none");
  }
  return {};
}

}  // namespace

std::size_t SolidTree::bytes() const noexcept {
  std::size_t sum =
      nodes.size() * sizeof(TreeNode) + loose.size() * sizeof(std::uint32_t) + boxes.size() * sizeof(BoxNode);
  for (const auto& lattice : lattices) sum += lattice->nodes_m.size() * sizeof(float);
  return sum;
}

Result<std::shared_ptr<const SolidTree>> build_tree(const Solid& solid) {
  if (const Result<void> checked = check(solid); !checked) return checked.error();
  auto tree = std::make_shared<const SolidTree>(TreeBuilder(solid).build());
  if (const Result<void> checked = check_values(*tree); !checked) return checked.error();
  return tree;
}

}  // namespace telepalp::solids
