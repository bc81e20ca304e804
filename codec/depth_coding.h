#pragma once

#include <cstdint>
#include <string>

#include "codec/depth_packet.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// A frame that another depends on, and the crc that names it.
struct Reference {
  const DepthImage* depth = nullptr;  ///< none: the frame stands alone
  std::uint32_t crc = 0;
  std::uint16_t since_key = 0;  ///< of the frame that depends on it
};

/// A whole packet of `depth` as it is, of any mode.
[[nodiscard]] std::string write_frame(const DepthImage& depth, DepthMode mode, const Reference& reference);

/// The frame in a packet; it must be the one that the header's crc was made of.
[[nodiscard]] Result<DepthImage> read_frame(const Packet& packet, const Reference& reference);

}  // namespace telepalp::codec
