#pragma once

#include <array>
#include <span>

#include "haptic_station/solids/proxy/half_spaces.h"
#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// The walls of a solid near a point: one half-space for each part whose surface is near. Where solids are joined, all
/// parts count: in a crease or corner between them, each keeps the proxy out. Where solids are cut from each other,
/// only the part that gives the value counts: outside an edge there is free room beside each face.
struct Walls {
  static constexpr std::size_t kMost = 8;
  static constexpr double kNear_m = 0.001;  ///< a wall is near if its part's value is at most this
  /// A shorter gradient gives no wall: opposite sides of a mesh are equally near.
  static constexpr double kShortest = 0.1;

  std::size_t count = 0;
  double least_m = HUGE_VAL;  ///< least value of the parts that are near; HUGE_VAL: nothing is near

  [[nodiscard]] std::span<const HalfSpace> spaces() const noexcept { return {spaces_.data(), count}; }
  /// Adds the tangent half-space of a part with this value and gradient at `p`; of more than kMost parts, the nearest
  /// stay.
  void offer(const Eigen::Vector3d& p, double m, const Eigen::Vector3d& gradient) noexcept;

 private:
  std::array<HalfSpace, kMost> spaces_;
  std::array<double, kMost> values_m_;
};

/// The walls at a point of the tree's frame, for the solid that is larger by `swell_m` on all sides. Real-time safe.
[[nodiscard]] Walls walls_at(const SolidTree& tree, const Eigen::Vector3d& p, double swell_m) noexcept;

/// The same, of these members of the outermost union only.
[[nodiscard]] Walls walls_of(const SolidTree& tree, std::span<const std::uint32_t> members, const Eigen::Vector3d& p,
                             double swell_m) noexcept;

}  // namespace telepalp::solids
