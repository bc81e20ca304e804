#pragma once

#include "support/isosurface/isosurface.h"

namespace telepalp::isosurface {

/// The points at which the field is sampled: a cubic lattice with half the side of the smallest cell as its step.
struct Lattice {
  Eigen::Vector3d origin;
  double step_m;
  int halvings;  ///< of a largest cell to a smallest one

  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3i& node) const noexcept {
    return origin + step_m * node.cast<double>();
  }
  /// Side of a cell that has been halved `level` times, in steps.
  [[nodiscard]] int side(int level) const noexcept { return 2 << (halvings - level); }
};

inline constexpr int kCoordinateBits = 20;

/// A key of a node, and of a cell by its lowest corner and level. Coordinates: 0 to 2^20 - 1.
[[nodiscard]] inline std::uint64_t key_of(const Eigen::Vector3i& node, int level = 0) noexcept {
  return static_cast<std::uint64_t>(node.x()) | static_cast<std::uint64_t>(node.y()) << kCoordinateBits |
         static_cast<std::uint64_t>(node.z()) << 2 * kCoordinateBits |
         static_cast<std::uint64_t>(level) << 3 * kCoordinateBits;
}

/// The corner of a cell with this number, whose bits are x 1, y 2, z 4; in units of the side.
[[nodiscard]] inline Eigen::Vector3i corner(int number) noexcept {
  return {number & 1, (number >> 1) & 1, (number >> 2) & 1};
}

}  // namespace telepalp::isosurface
