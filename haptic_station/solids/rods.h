#pragma once

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// A rod with round ends: all points within `radius_m` of the line from `from_m` to `to_m`.
struct Rod {
  Eigen::Vector3d from_m;
  Eigen::Vector3d to_m;
  double radius_m;
};

/// A solid of rods that can be placed anew without an allocation. What follows its surface, such as a SolidProxy, must
/// start anew after that.
class Rods {
 public:
  /// `count` rods of length and radius zero at the origin. Allocates.
  explicit Rods(std::size_t count);

  void place(std::size_t rod, const Rod& at) noexcept {
    auto& n = tree_.nodes[rod].numbers;
    for (int axis = 0; axis < 3; ++axis) {
      n[static_cast<std::size_t>(axis)] = at.from_m[axis];
      n[static_cast<std::size_t>(axis + 3)] = at.to_m[axis];
    }
    n[6] = at.radius_m;
  }
  [[nodiscard]] const SolidTree& tree() const noexcept { return tree_; }

 private:
  SolidTree tree_;  // the rods' nodes, then the union, of which they are unbounded members: no boxes to keep
};

}  // namespace telepalp::solids
