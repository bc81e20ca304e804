#pragma once

#include <cstddef>

#include "messages/inside.pb.h"

namespace telepalp::wire {

inline constexpr std::size_t kMaxUltrasoundBytes = std::size_t{64} << 10;  ///< of the JPEG in a message
inline constexpr int kMostStructures = 8;
inline constexpr std::size_t kMostStructurePoints = 65535;  ///< of one structure

/// True if the message has a picture exactly when the probe is on the skin, the picture has at most kMaxUltrasoundBytes
/// and begins as a JPEG does, and lengths and directions are possible: an image of 1 mm to 1 m, a probe within 10 m of
/// the camera.
[[nodiscard]] bool is_valid(const msg::UltrasoundImage& image) noexcept;

/// True if there are at most kMostStructures structures, each triangle names three points of its structure, and all
/// lengths are finite and below 10 m.
[[nodiscard]] bool is_valid(const msg::InnerStructures& inside) noexcept;

}  // namespace telepalp::wire
