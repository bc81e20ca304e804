#pragma once

#include <Eigen/Core>
#include <array>

namespace telepalp::core {

/// Three numbers of a tick's sample as a vector, in the same unit and frame.
[[nodiscard]] inline Eigen::Vector3d vector_of(const std::array<float, 3>& numbers) noexcept {
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace telepalp::core
