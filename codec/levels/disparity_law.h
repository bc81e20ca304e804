#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace telepalp::codec {

/// The levels of a camera that measures disparity in whole steps (Kinect-class): 1/z grows by the same amount from
/// level to level, and z is then rounded to whole units. Two numbers tell hundreds of levels. Integers alone, so that
/// every machine computes the same.
struct DisparityLaw {
  static constexpr std::uint64_t kOne = std::uint64_t{1} << 40;
  static constexpr std::uint32_t kMostSteps = 65535;

  std::uint64_t farthest = kOne;  ///< kOne / z of step 0, 1 … kOne
  std::uint32_t step = 1;         ///< above 0

  /// z of the step that is `n` nearer than the farthest, rounded.
  [[nodiscard]] std::uint64_t level_at(std::uint32_t n) const noexcept {
    const std::uint64_t inverse = farthest + std::uint64_t{step} * n;
    return (kOne + inverse / 2) / inverse;
  }
  /// The step whose z is nearest.
  [[nodiscard]] std::uint32_t step_of(std::uint16_t level) const noexcept;
};

/// The law that ascending, positive `levels` follow best; nullopt for fewer than 16 or more than 4096, or where no law comes near. Those
/// that sensors without disparity make have none.
[[nodiscard]] std::optional<DisparityLaw> fit_disparity_law(std::span<const std::uint16_t> levels);

}  // namespace telepalp::codec
