#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "haptic_station/solids/solid.h"

namespace telepalp::solids {

/// A box along the axes. Unbounded sides are infinite.
struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());

  [[nodiscard]] bool bounded() const noexcept { return low.allFinite() && high.allFinite(); }
  /// Squared distance from `p` to the box; 0 inside.
  [[nodiscard]] double squared_distance_m2(const Eigen::Vector3d& p) const noexcept {
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
  }
};

/// Where a solid's value is guaranteed to be the distance to its surface: everywhere, outside the solid, or (Bound)
/// nowhere. Elsewhere the value has the right sign, and a magnitude of at most SolidTree::steepest times the distance.
enum class Exactness : std::uint8_t { Everywhere, Outside, Bound };

/// Value of a solid at a point.
struct SolidAt {
  double m;                  ///< signed distance or its bound [m], see Exactness; negative inside
  Eigen::Vector3d gradient;  ///< of `m`; its length is at most SolidTree::steepest, and 0 where opposite parts tie
  std::uint32_t part;  ///< index of the shape, blend or clip that gives `m`, at a tie the least; kNothing: a box does
};

/// A node that can be evaluated. Its placement maps its own frame to the frame of the operator that contains it:
/// p_above = scale turn p + shift. A shape that is neither a mesh nor turned is evaluated from two cache lines.
struct alignas(64) TreeNode {
  Op op = Op::Sphere;
  std::uint8_t axis = 0;
  Exactness exactness = Exactness::Everywhere;
  bool placed = false;          ///< false: the placement is the identity
  bool turned = false;          ///< false: `turn` is the identity
  std::uint32_t first = 0;      ///< node of an operand; of a union, index in `loose` of its first unbounded member
  std::uint32_t second = 0;     ///< node of an operand; of a union, one past its last unbounded member in `loose`
  std::uint32_t hierarchy = 0;  ///< of a union: index in `boxes` of the root over its bounded members, or kNothing
  double scale = 1.0;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  std::array<double, 8> numbers{};           ///< of a shape, a clip or a blend; of a difference, kSeam_m in its frame
  const DistanceLattice* lattice = nullptr;  ///< of a mesh; borrowed from the tree's `lattices`
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Box box;  ///< contains the node's solid, in the frame of the operator that contains the node
};
inline constexpr std::uint32_t kNothing = 0xffffffff;

/// What is cut away from a solid is larger by this on all sides [m]. Without it, a sheet of zero thickness would remain
/// where both solids share a face, and would be felt. With it, a solid less itself is empty.
inline constexpr double kSeam_m = 3e-6;

/// A node of the hierarchy of boxes over the members of a union: up to four boxes, tested together.
struct alignas(64) BoxNode {  // two cache lines
  static constexpr std::size_t kWidth = 4;
  static constexpr std::uint32_t kMember = 0x80000000;  ///< flag of a child that is a member, not a BoxNode

  std::array<std::array<float, kWidth>, 3> low{};   ///< per axis, then per child; rounded outwards
  std::array<std::array<float, kWidth>, 3> high{};  ///< a lane without a child has an empty box, infinitely far away
  std::array<std::uint32_t, kWidth> child{kNothing, kNothing, kNothing, kNothing};
};

/// A solid in the form that is evaluated: flat arrays, made by build_tree().
struct SolidTree {
  std::vector<TreeNode> nodes;
  std::vector<std::uint32_t> loose;  ///< indices in `nodes` of the unbounded members of unions
  std::vector<BoxNode> boxes;
  std::uint32_t root = 0;
  std::size_t shapes = 0;
  double steepest = 1.0;                                         ///< Lipschitz constant: 1, or sqrt(3) with a mesh
  std::vector<std::shared_ptr<const DistanceLattice>> lattices;  // shared: the solid's description holds them too

  [[nodiscard]] const Box& box() const noexcept { return nodes[root].box; }
  [[nodiscard]] Exactness exactness() const noexcept { return nodes[root].exactness; }
  [[nodiscard]] std::size_t bytes() const noexcept;
};

/// Makes a solid ready for evaluation. Unions that are operands of a union become one with it. Allocates.
/// Error: the description is incomplete, nests too deeply, has a bad number, or names a mesh that was not read.
[[nodiscard]] Result<std::shared_ptr<const SolidTree>> build_tree(const Solid& solid);

/// Value and exact gradient at a point, in the solid's frame. A part is skipped if its box shows that it cannot give
/// the value; so the cost of a union of separate solids grows with the logarithm of their number. On an exact tie the
/// gradient is the mean over all tied members of a union, or over both operands of another operator. A point that is
/// not finite is infinitely far outside. Real-time safe. Sources: constructive solid geometry by minimum and maximum,
/// paper S2 (docs/sources.md) III.A; a blend is the quadratic smooth minimum, whose value is lower than the minimum by
/// at most a quarter of its width.
[[nodiscard]] SolidAt solid_at(const SolidTree& tree, const Eigen::Vector3d& point_m) noexcept;

}  // namespace telepalp::solids
