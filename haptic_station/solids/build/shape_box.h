#pragma once

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// The box of a shape in its own frame.
[[nodiscard]] Box shape_box(const TreeNode& shape) noexcept;

/// The box about a box that the node's placement has moved.
[[nodiscard]] Box placed_box(const Box& box, const TreeNode& node) noexcept;

[[nodiscard]] Box joined(const Box& a, const Box& b) noexcept;
/// Of boxes that do not meet, the first: the solid is empty, and its distance has no box.
[[nodiscard]] Box common(const Box& a, const Box& b) noexcept;
[[nodiscard]] Box widened(const Box& box, double by_m) noexcept;
/// The box of what a plane along two axes leaves; other planes leave the box as it is. `normal`: unit.
[[nodiscard]] Box clipped(const Box& box, const Eigen::Vector3d& normal, double offset_m) noexcept;

}  // namespace telepalp::solids
