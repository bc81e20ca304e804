#include "haptic_station/solids/build/box_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "haptic_station/solids/build/shape_box.h"

namespace telepalp::solids {
namespace {

using Members = std::span<std::uint32_t>;

Box box_of(const SolidTree& tree, Members members) {
  Box box = tree.nodes[members.front()].box;
  for (const std::uint32_t member : members) box = joined(box, tree.nodes[member].box);
  return box;
}

/// Splits at the median member along the longest side. A single member stays whole.
std::array<Members, 2> halves(const SolidTree& tree, Members members) {
  if (members.size() < 2) return {members, Members{}};
  const Box box = box_of(tree, members);
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
  const auto place = [&](std::uint32_t member) {
    return tree.nodes[member].box.low[axis] + tree.nodes[member].box.high[axis];
  };
  std::nth_element(members.begin(), middle, members.end(), [&](std::uint32_t a, std::uint32_t b) {
    return place(a) != place(b) ? place(a) < place(b) : a < b;
  });
  return {Members{members.begin(), middle}, Members{middle, members.end()}};
}

float rounded_down(double value) {
  const auto nearest = static_cast<float>(value);
  return double{nearest} <= value ? nearest : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

void set_child(BoxNode& node, std::size_t lane, std::uint32_t child, const Box& box) {
  node.child[lane] = child;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.low[axis][lane] = rounded_down(box.low[static_cast<Eigen::Index>(axis)]);
    node.high[axis][lane] = -rounded_down(-box.high[static_cast<Eigen::Index>(axis)]);
  }
}

std::uint32_t add_quarters(SolidTree& tree, Members members) {
  const auto index = static_cast<std::uint32_t>(tree.boxes.size());
  BoxNode node;
  for (auto& axis : node.low) axis.fill(std::numeric_limits<float>::infinity());
  for (auto& axis : node.high) axis.fill(-std::numeric_limits<float>::infinity());
  tree.boxes.push_back(node);
  std::size_t lane = 0;
  for (const Members half : halves(tree, members)) {
    if (half.empty()) continue;
    for (const Members quarter : halves(tree, half)) {
      if (quarter.empty()) continue;
      const Box box = box_of(tree, quarter);
      const std::uint32_t child =
          quarter.size() == 1 ? quarter.front() | BoxNode::kMember : add_quarters(tree, quarter);
      set_child(tree.boxes[index], lane++, child, box);
    }
  }
  return index;
}

}  // namespace

std::uint32_t add_hierarchy(SolidTree& tree, std::vector<std::uint32_t> members) {
  return members.empty() ? kNothing : add_quarters(tree, members);
}

}  // namespace telepalp::solids
