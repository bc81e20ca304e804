#include "haptic_station/solids/build/box_hierarchy.h"

#include <algorithm>
#include <span>

#include "haptic_station/solids/build/shape_box.h"

namespace telepalp::solids {
namespace {

std::uint32_t add_halves(SolidTree& tree, std::span<std::uint32_t> members) {
  const auto index = static_cast<std::uint32_t>(tree.boxes.size());
  Box box = tree.nodes[members.front()].box;
  for (const std::uint32_t member : members) box = joined(box, tree.nodes[member].box);
  tree.boxes.push_back({.box = box});
  if (members.size() == 1) {
    tree.boxes[index].right = members.front();
    return index;
  }
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
  const auto place = [&](std::uint32_t member) {
    return tree.nodes[member].box.low[axis] + tree.nodes[member].box.high[axis];
  };
  std::nth_element(members.begin(), middle, members.end(), [&](std::uint32_t a, std::uint32_t b) {
    return place(a) != place(b) ? place(a) < place(b) : a < b;
  });
  const std::uint32_t left = add_halves(tree, {members.begin(), middle});
  const std::uint32_t right = add_halves(tree, {middle, members.end()});
  tree.boxes[index].left = left;
  tree.boxes[index].right = right;
  return index;
}

}  // namespace

std::uint32_t add_hierarchy(SolidTree& tree, std::vector<std::uint32_t> members) {
  return members.empty() ? kNothing : add_halves(tree, members);
}

}  // namespace telepalp::solids
