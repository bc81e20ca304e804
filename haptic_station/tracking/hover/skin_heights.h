#pragma once

#include <array>
#include <limits>

#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::tracking {

/// The highest point of what the camera sees, above each cell of the horizontal plane of H, the haptic base's frame. A
/// hand that is guided over the patient looks here how high it must be (guided_hand.h). A plain value without pointers.
class SkinHeights {
 public:
  /// Keeps `at` if it is the highest point of its cell so far. A point outside the map is left out.
  void add(const Point<HapticBase>& at) noexcept;

  /// The highest y [m] within `radius_m` of (x, z) of `at`, to the accuracy of one cell; -infinity where nothing is
  /// seen. At most (2 radius_m / kCell_m + 2)² cells are read.
  [[nodiscard]] double highest(const Point<HapticBase>& at, double radius_m) const noexcept;

  static constexpr double kCell_m = 0.01;

 private:
  static constexpr int kSide = 120;  ///< cells; the reach of a browser's hand is 0.5 m in each direction
  static constexpr float kUnseen = -std::numeric_limits<float>::infinity();
  /// The cell of a coordinate, which may lie outside the map.
  [[nodiscard]] static int cell(double coordinate_m) noexcept;

  std::array<float, static_cast<std::size_t>(kSide)* kSide> highest_m_ = [] {
    std::array<float, static_cast<std::size_t>(kSide) * kSide> all{};
    all.fill(kUnseen);
    return all;
  }();
};

/// The heights of one depth image. Of each block of pixels (at most 160 blocks across) the median depth counts, so that
/// a single wrong pixel raises nothing. `camera` and `depth` must be of one size. Allocates nothing.
[[nodiscard]] SkinHeights heights_of(const DepthImage& depth, const Intrinsics& camera,
                                     const Transform<HapticBase, DepthCamera>& haptic_from_camera) noexcept;

}  // namespace telepalp::tracking
