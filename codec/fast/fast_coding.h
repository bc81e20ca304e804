#pragma once

#include <optional>
#include <string>

#include "codec/packet/depth_packet.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// A packet's body and its format.
struct Body {
  Coding coding = Coding::Stored;
  std::string bytes;
};

/// Codes by tokens; with more than kMaxTokenLevels levels, by zstd alone. Stores the raw samples if they are smaller.
[[nodiscard]] Body encode_fast(const DepthImage& depth);

/// Stores the raw samples.
[[nodiscard]] Body stored(const DepthImage& depth);

/// Fills `samples` from a body of Coding::Stored, Zstd or Tokens. False when it is damaged.
[[nodiscard]] bool decode_fast(const Packet& packet, std::span<std::uint16_t> samples);

}  // namespace telepalp::codec
