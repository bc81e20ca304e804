#pragma once

#include <cstddef>

#include "messages/inside.pb.h"

namespace telepalp::wire {

inline constexpr std::size_t kMaxUltrasoundBytes = std::size_t{64} << 10;  ///< of the JPEG in a message
inline constexpr int kMostStructures = 8;
inline constexpr std::size_t kMostStructurePoints = 65535;  ///< of one structure

/// True if the message has a picture exactly when the probe is on the skin, the picture has at most kMaxUltrasoundBytes
/// and begins as a JPEG does, the imaged area has sides of 1 mm to 1 m, the probe's coordinates in the camera's frame
/// are within ±10 m, and its directions are unit vectors. Without a picture, the probe's pose is not checked.
[[nodiscard]] bool is_valid(const msg::UltrasoundImage& image) noexcept;

/// True if the structures are at most kMostStructures, each with at most kMostStructurePoints points, each triangle
/// names three points of its structure, coordinates are within ±10 m, and the rotation is a unit quaternion.
[[nodiscard]] bool is_valid(const msg::InnerStructures& inside) noexcept;

}  // namespace telepalp::wire
