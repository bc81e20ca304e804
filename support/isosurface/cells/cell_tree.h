#pragma once

#include "support/isosurface/cells/key_map.h"
#include "support/isosurface/cells/lattice.h"

namespace telepalp::isosurface {

/// A cell that is not divided. `inside`: one bit for each corner.
struct Leaf {
  Eigen::Vector3i low;
  std::uint8_t level = 0;
  std::uint8_t inside = 0;
};

/// The cells near the surface. Cells that the surface certainly does not reach are absent.
class CellTree {
 public:
  static constexpr std::int32_t kDivided = -1;
  static constexpr std::int32_t kAbsent = -2;

  explicit CellTree(const Lattice& lattice) : lattice_(lattice) {}

  void add(const Leaf& leaf);
  void divide(const Eigen::Vector3i& low, int level) { *cells_.insert(key_of(low, level)).first = kDivided; }

  /// The cell of this level at this lowest corner: the index of a leaf, kDivided or kAbsent.
  [[nodiscard]] std::int32_t cell(const Eigen::Vector3i& low, int level) const noexcept;
  /// The leaf of at most this level that contains the cell with this lowest corner and level; kDivided: smaller leaves
  /// do; kAbsent.
  [[nodiscard]] std::int32_t leaf_over(const Eigen::Vector3i& low, int level) const noexcept;

  [[nodiscard]] const std::vector<Leaf>& leaves() const noexcept { return leaves_; }
  [[nodiscard]] const Lattice& lattice() const noexcept { return lattice_; }

 private:
  const Lattice& lattice_;  // borrowed
  std::vector<Leaf> leaves_;
  KeyMap<std::int32_t> cells_;
};

/// The cells with what remained doubtful in the smallest of them.
struct Refined {
  CellTree tree;
  std::optional<Tight> tightest{};
  std::size_t unsure = 0;
};

/// The error of an extraction that `Grid::stop` has ended.
[[nodiscard]] Error stopped();

/// Halves the cells of `grid` as extract() says. `cells`: largest cells along each axis. Error: too many cells, or
/// `grid.stop` was requested.
[[nodiscard]] Result<Refined> refine(const Field& field, const Grid& grid, const Lattice& lattice,
                                     const Eigen::Vector3i& cells);

}  // namespace telepalp::isosurface
