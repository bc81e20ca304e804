#pragma once

#include <optional>
#include <string>

#include "codec/packet/depth_packet.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// A packet's body, and how it is written.
struct Body {
  Coding coding = Coding::Stored;
  std::string bytes;
};

/// The shortest of tokens, plain zstd (when there are more levels than tokens may have) and samples as they are.
[[nodiscard]] Body encode_fast(const DepthImage& depth);

/// The samples as they are, which always works.
[[nodiscard]] Body stored(const DepthImage& depth);

/// Fills `samples` from a body of Coding::Stored, Zstd or Tokens. False when it is damaged.
[[nodiscard]] bool decode_fast(const Packet& packet, std::span<std::uint16_t> samples);

}  // namespace telepalp::codec
