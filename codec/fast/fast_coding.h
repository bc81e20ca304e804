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

/// Encodes an image in the mode `fast`. Each pixel is predicted from its neighbours. A token states how many
/// consecutive predictions are right, and how the next pixel differs (codec/fast/tokens.h); zstd compresses the tokens.
/// An image with more than kMaxTokenLevels (16 384) different depths is compressed by zstd without tokens. If the
/// result is not smaller than the raw samples, these are stored instead.
[[nodiscard]] Body encode_fast(const DepthImage& depth);

/// Stores the raw samples.
[[nodiscard]] Body stored(const DepthImage& depth);

/// Fills `samples` from a body of Coding::Stored, Zstd or Tokens. False when it is damaged.
[[nodiscard]] bool decode_fast(const Packet& packet, std::span<std::uint16_t> samples);

}  // namespace telepalp::codec
