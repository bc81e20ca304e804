#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace telepalp::codec {

/// The levels of a camera that measures disparity in whole steps (Kinect-class): 1/z grows by the same amount from
/// level to level, and z is then rounded to whole units of a sample. So two numbers predict hundreds of levels. The
/// arithmetic uses only integers, so that every machine computes the same levels.
struct DisparityLaw {
  static constexpr std::uint64_t kOne = std::uint64_t{1} << 40;
  static constexpr std::uint32_t kMostSteps = 65535;

  std::uint64_t farthest = kOne;  ///< kOne / z at step 0, the farthest level [z: units of a sample]; 1 to kOne
  std::uint32_t step = 1;         ///< by which kOne / z grows from one step to the next; above 0

  /// z [units of a sample] of the level that is `n` steps nearer than the farthest one, rounded.
  [[nodiscard]] std::uint64_t level_at(std::uint32_t n) const noexcept {
    const std::uint64_t inverse = farthest + std::uint64_t{step} * n;
    return (kOne + inverse / 2) / inverse;
  }
  /// The number of the step whose 1/z is nearest to that of `level`, which must be above 0.
  [[nodiscard]] std::uint32_t step_of(std::uint16_t level) const noexcept;
};

/// The law that fits ascending, positive `levels` best. nullopt for fewer than 16 or more than 4096 levels, or when no
/// law fits, as for a sensor that does not measure disparity.
[[nodiscard]] std::optional<DisparityLaw> fit_disparity_law(std::span<const std::uint16_t> levels);

}  // namespace telepalp::codec
