#pragma once

#include <cstddef>
#include <span>

#include "proto/words/result.h"

namespace telepalp::codec {

/// The fields of a VP8 frame's header (RFC 6386, section 9.1) that the decoder checks.
struct Vp8Header {
  bool key_frame = false;
  int width = 0;  ///< pixels; 0 in a predicted frame, which does not state its size
  int height = 0;
};

/// Parses the header. Error: the packet is cut short, is no VP8 frame, shows no picture, or is larger than
/// kMaxImageSide a side or kMaxVideoPixels.
[[nodiscard]] Result<Vp8Header> read_vp8_header(std::span<const std::byte> packet);

/// The error for a damaged packet. `what`: the damage, in words.
[[nodiscard]] Error damaged_video(std::string what);

}  // namespace telepalp::codec
