#pragma once

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// The bounding box of a shape in the shape's own frame.
[[nodiscard]] Box shape_box(const TreeNode& shape) noexcept;

/// The bounding box of `box` after the node's placement turned, scaled and moved it. Infinite if `box` is unbounded.
[[nodiscard]] Box placed_box(const Box& box, const TreeNode& node) noexcept;

/// The smallest box that contains both boxes.
[[nodiscard]] Box joined(const Box& a, const Box& b) noexcept;
/// The intersection; `a` if the boxes do not meet: their solids' intersection is then empty, so any box bounds it.
[[nodiscard]] Box common(const Box& a, const Box& b) noexcept;
/// `box` extended by `by_m` on each side.
[[nodiscard]] Box widened(const Box& box, double by_m) noexcept;
/// The part of `box` where normal . x < offset_m, if the plane is perpendicular to a coordinate axis; otherwise `box`
/// unchanged, which bounds the part too. `normal`: unit.
[[nodiscard]] Box clipped(const Box& box, const Eigen::Vector3d& normal, double offset_m) noexcept;

}  // namespace telepalp::solids
