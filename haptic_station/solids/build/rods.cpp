#include "haptic_station/solids/rods.h"

namespace telepalp::solids {

Rods::Rods(std::size_t count) {
  tree_.nodes.resize(count + 1);
  tree_.shapes = count;
  for (std::uint32_t rod = 0; rod < count; ++rod) {
    tree_.nodes[rod].op = Op::Capsule;
    tree_.loose.push_back(rod);
  }
  TreeNode& all = tree_.nodes.back();
  all.op = Op::Union;
  all.exactness = Exactness::Outside;
  all.second = static_cast<std::uint32_t>(count);
  all.hierarchy = kNothing;
  tree_.root = static_cast<std::uint32_t>(count);
}

}  // namespace telepalp::solids
