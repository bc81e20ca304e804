#include "haptic_station/solids/mesh/tree_field.h"

#include <algorithm>

#include "haptic_station/solids/build/shape_box.h"

namespace telepalp::solids {
namespace {

/// The least thickness of a shape, or half of it for a round shape, in the shape's own frame [m]; infinite for a plane.
double size_of(const TreeNode& shape) noexcept {
  const auto& n = shape.numbers;
  switch (shape.op) {
    case Op::Sphere:
      return n[0];
    case Op::Capsule:
      return n[6];
    case Op::Torus:
    case Op::Arc:
      return n[1];
    case Op::Box:
      return 2.0 * std::min({n[0], n[1], n[2]});
    case Op::Ellipsoid:
      return std::min({n[0], n[1], n[2]});
    case Op::Cylinder:
      return std::min(n[0], 2.0 * n[1]);
    case Op::Mesh:
      return 2.0 * shape.lattice->spacing_m;
    default:
      return std::numeric_limits<double>::infinity();
  }
}

class FeatureList {
 public:
  explicit FeatureList(const SolidTree& tree) : tree_(tree) {}

  std::vector<isosurface::Feature> take() {
    add(tree_.root, {});
    return std::move(features_);
  }

 private:
  /// `above`: nodes that contain the node, the outermost first.
  void add(std::uint32_t index, std::vector<const TreeNode*> above) {
    const TreeNode& node = tree_.nodes[index];
    if (node.op == Op::Union || node.op == Op::Intersection || node.op == Op::Difference || node.op == Op::Blend ||
        node.op == Op::Clip) {
      above.push_back(&node);
      for (const std::uint32_t operand : operands_of(node)) add(operand, above);
      return;
    }
    Box box = node.box;
    double size_m = size_of(node) * node.scale;
    for (auto outer = above.rbegin(); outer != above.rend(); ++outer)
      if ((*outer)->placed) {
        box = placed_box(box, **outer);
        size_m *= (*outer)->scale;
      }
    if (box.bounded()) features_.push_back({{box.low, box.high}, size_m});
  }

  [[nodiscard]] std::vector<std::uint32_t> operands_of(const TreeNode& node) const {
    if (node.op == Op::Clip) return {node.first};
    if (node.op != Op::Union) return {node.first, node.second};
    std::vector<std::uint32_t> members(tree_.loose.begin() + node.first, tree_.loose.begin() + node.second);
    if (node.hierarchy != kNothing) gather(node.hierarchy, members);
    return members;
  }
  void gather(std::uint32_t box, std::vector<std::uint32_t>& members) const {
    for (const std::uint32_t child : tree_.boxes[box].child) {
      if (child == kNothing) continue;
      if ((child & BoxNode::kMember) != 0)
        members.push_back(child & ~BoxNode::kMember);
      else
        gather(child, members);
    }
  }

  const SolidTree& tree_;
  std::vector<isosurface::Feature> features_;
};

}  // namespace

isosurface::Field field_of(const SolidTree& tree) {
  // The copy has no seams. Next to a seam the value is nearly zero, and only micrometre cells could show that no solid
  // is there. Without seams the value on such a sheet is exactly zero, and the extraction sees that it encloses
  // nothing.
  const auto seamless = std::make_shared<SolidTree>(tree);
  for (TreeNode& node : seamless->nodes)
    if (node.op == Op::Difference) node.numbers[0] = 0.0;
  return {.at =
              [seamless](const Eigen::Vector3d& p) {
                const SolidAt at = solid_at(*seamless, p);
                return isosurface::FieldAt{at.m, at.gradient};
              },
          .steepest = tree.steepest,
          .features = FeatureList(tree).take()};
}

}  // namespace telepalp::solids
