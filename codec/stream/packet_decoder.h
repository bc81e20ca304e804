#pragma once

#include <cstdint>
#include <optional>

#include "codec/levels/level_palette.h"
#include "codec/packet/depth_packet.h"
#include "codec/stream/frame_coding.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// True when frames of `mode` between key frames are predicted from the frame before.
[[nodiscard]] constexpr bool is_predictive(DepthMode mode) noexcept {
  return mode == DepthMode::Temporal || mode == DepthMode::Bounded;
}

/// Decodes parsed packets in order and keeps the last frame of a predictive mode as reference for the next one.
class PacketDecoder {
 public:
  /// Decodes the next packet. After an error the reference frame is unchanged.
  [[nodiscard]] Result<DepthImage> decode(const Packet& packet);

 private:
  [[nodiscard]] bool has_reference_of(const PacketHeader& header) const noexcept;
  [[nodiscard]] Reference reference() const noexcept;

  DepthImage previous_;
  std::optional<LevelPalette> previous_palette_;  // of the previous frame; nullopt: read_frame() gave none
  std::uint32_t previous_crc_ = 0;
};

}  // namespace telepalp::codec
