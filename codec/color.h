#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// Encodes as JPEG with 4:2:0 chroma subsampling. `quality` 1 to 100. `color` must be well formed and not empty.
[[nodiscard]] std::string encode_color(const ColorImage& color, int quality = 85);

/// Encodes a grey picture, rows from the top, as JPEG with one component. `gray` has width x height bytes, at least
/// one.
[[nodiscard]] std::string encode_gray(std::span<const std::uint8_t> gray, int width, int height, int quality = 85);

/// Decodes `jpeg`. The header is checked against kMaxImageSide (4096 pixels) before anything is allocated; a truncated
/// or corrupt picture is an error, never half a picture.
[[nodiscard]] Result<ColorImage> decode_color(std::span<const std::byte> jpeg);

}  // namespace telepalp::codec
