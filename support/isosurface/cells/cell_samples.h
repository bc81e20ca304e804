#pragma once

#include <array>

#include "support/isosurface/cells/key_map.h"
#include "support/isosurface/cells/lattice.h"

namespace telepalp::isosurface {

/// The field at corners, edge middles, face middles and the middle of a cell: index i + 3 j + 9 k, with i, j, k in
/// {0, 1, 2} half sides from the lowest corner.
struct CellSamples {
  Eigen::Vector3d low;
  double side_m = 0.0;
  std::array<FieldAt, 27> at{};

  [[nodiscard]] Eigen::Vector3d place(std::size_t index) const noexcept {
    const auto i = static_cast<int>(index);
    return low + 0.5 * side_m * Eigen::Vector3i(i % 3, i / 3 % 3, i / 9).cast<double>();
  }
  [[nodiscard]] bool inside(std::size_t index) const noexcept { return at[index].m < 0.0; }
};

/// Index in CellSamples::at of a corner by its number.
[[nodiscard]] inline std::size_t index_of_corner(int number) noexcept {
  return static_cast<std::size_t>(2 * ((number & 1) + 3 * ((number >> 1) & 1) + 9 * ((number >> 2) & 1)));
}

/// Samples a field and remembers up to kMost samples, which neighbouring cells share.
class Sampler {
 public:
  /// `gradients`: false: the samples' gradients are zero.
  Sampler(const Field& field, const Lattice& lattice, bool gradients)
      : field_(field), lattice_(lattice), gradients_(gradients) {}

  [[nodiscard]] const FieldAt& at(const Eigen::Vector3i& node);
  [[nodiscard]] CellSamples of_cell(const Eigen::Vector3i& low, int side);

 private:
  static constexpr std::size_t kMost = 500'000;
  const Field& field_;      // borrowed
  const Lattice& lattice_;  // borrowed
  bool gradients_;
  KeyMap<FieldAt> known_;
};

}  // namespace telepalp::isosurface
