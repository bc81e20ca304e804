#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::tissue {

/// Linear tetrahedra lock: a prism of two cells across bends 1.9 times too stiffly at Poisson's ratio 0.3, and 3.2
/// times at 0.45. They remain a setting, to show the price of quadratic ones (`telepalp-bench needle --part fem`).
enum class ElementOrder { Linear, Quadratic };

/// The sides of a prism that a tool can touch; its bottom is fixed.
enum class PrismSide { Left, Right, Back, Front, Top };  // -x, +x, -z, +z, +y
inline constexpr std::size_t kPrismSides = 5;

/// The lattice of cells, each cut into six tetrahedra.
struct PrismGrid {
  Eigen::Vector3d size_m{0.02, 0.1, 0.02};  ///< along x, y and z
  int across = 2;                           ///< cells along x, and along z
  int along = 6;                            ///< cells along y
  /// The end of cell i is at (i / along)^grading of the length: above 1, the cells at the bottom are shorter. The clamp
  /// at the bottom is where a mesh errs most: 1.6 with 6 cells is as right as 1 with 10.
  double grading = 1.6;
  ElementOrder order = ElementOrder::Quadratic;
};

/// A face of a tetrahedron: its corners, and with ElementOrder::Quadratic the middles of the edges from each corner to
/// the next one.
using SideTriangle = std::array<std::uint32_t, 6>;

/// Tetrahedra with straight edges. The first four nodes of a tetrahedron are its corners; with ElementOrder::Quadratic
/// the other six are the middles of its edges, in the order of kTetrahedronEdges.
struct TetMesh {
  ElementOrder order = ElementOrder::Quadratic;
  std::vector<Eigen::Vector3d> nodes;  ///< [m]; those that are fixed come first
  std::size_t fixed = 0;
  std::vector<std::array<std::uint32_t, 10>> tetrahedra;
  /// The surface that a tool can touch, by sides, counterclockwise from outside.
  std::array<std::vector<SideTriangle>, kPrismSides> sides;
};
inline constexpr std::array<std::array<std::size_t, 2>, 6> kTetrahedronEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Nodes of a tetrahedron: 4 or 10.
[[nodiscard]] constexpr std::size_t nodes_of(ElementOrder order) noexcept {
  return order == ElementOrder::Linear ? 4 : 10;
}

/// A prism that stands on the plane y = 0, on which its bottom is fixed; its axis is the y axis. Error: a number out of
/// range, or more than 4000 nodes.
[[nodiscard]] Result<TetMesh> make_prism(const PrismGrid& grid);

/// Error: a node that is not a number or does not exist, an edge without length, a tetrahedron that is flat or turned
/// inside out, or nothing that is fixed.
[[nodiscard]] Result<void> check(const TetMesh& mesh);

}  // namespace telepalp::tissue
