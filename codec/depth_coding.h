#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "codec/depth_bound.h"
#include "codec/depth_packet.h"
#include "codec/level_palette.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// A frame that another depends on, and the crc that names it.
struct Reference {
  const DepthImage* depth = nullptr;      ///< none: the frame stands alone
  const LevelPalette* palette = nullptr;  ///< its own, where it is at hand
  std::uint32_t crc = 0;
  std::uint16_t since_key = 0;  ///< of the frame that depends on it
};

/// A whole packet of `depth` as it is, of any mode.
[[nodiscard]] std::string write_frame(const DepthImage& depth, DepthMode mode, const Reference& reference);

/// The same of any mode but Fast, where the frame's palette is at hand.
[[nodiscard]] std::string write_frame(const DepthImage& depth, const LevelPalette& palette, DepthMode mode,
                                      const Reference& reference);

/// A packet, and the frame as its decoder will have it.
struct WrittenFrame {
  std::string packet;
  DepthImage depth;
  LevelPalette palette;
};

/// A packet of `depth` with each pixel moved within its bound, so that it takes fewer bytes. `palette` is the frame's
/// own; `stand_ins` as for within_bounds().
[[nodiscard]] WrittenFrame write_bounded(const DepthImage& depth, const LevelPalette& palette, StandIns& stand_ins,
                                         const Reference& reference);

/// A frame as it was decoded.
struct DecodedFrame {
  DepthImage depth;
  std::optional<LevelPalette> palette;  ///< where the packet has it
};

/// The frame in a packet; it must be the one that the header's crc was made of.
[[nodiscard]] Result<DecodedFrame> read_frame(const Packet& packet, const Reference& reference);

}  // namespace telepalp::codec
