#pragma once

#include <cstddef>
#include <span>

#include "proto/words/result.h"

namespace telepalp::codec {

/// What the first bytes of a VP8 frame state (RFC 6386, section 9.1).
struct Vp8Header {
  bool key_frame = false;
  int width = 0;  ///< pixels; of a key frame alone
  int height = 0;
};

/// Parses the header. Error: the packet is cut short, is no VP8 frame, shows no picture, or is larger than
/// kMaxImageSide a side or kMaxVideoPixels.
[[nodiscard]] Result<Vp8Header> read_vp8_header(std::span<const std::byte> packet);

/// The error for a damaged packet. `what`: the damage, in words.
[[nodiscard]] Error damaged_video(std::string what);

}  // namespace telepalp::codec
