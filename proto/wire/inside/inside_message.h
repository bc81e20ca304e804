#pragma once

#include <cstddef>

#include "messages/inside.pb.h"

namespace telepalp::wire {

inline constexpr std::size_t kMaxUltrasoundBytes = std::size_t{64} << 10;  ///< of the JPEG in a message
inline constexpr int kMostStructures = 8;
inline constexpr std::size_t kMostStructurePoints = 65535;  ///< of one structure

/// True if the image is empty, or a JPEG of at most kMaxUltrasoundBytes by its first bytes, and the lengths and
/// directions are finite and possible: an image at most 1 m wide and deep, a probe within 10 m of the camera.
[[nodiscard]] bool is_valid(const msg::UltrasoundImage& image) noexcept;

/// True if there are at most kMostStructures structures, each triangle names three points of its structure, and all
/// lengths are finite and below 10 m.
[[nodiscard]] bool is_valid(const msg::InnerStructures& inside) noexcept;

}  // namespace telepalp::wire
