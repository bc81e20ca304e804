#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "codec/bounded/reconstruction.h"
#include "codec/context/context_coding.h"
#include "codec/levels/level_palette.h"
#include "codec/packet/depth_packet.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// The frame that another frame is predicted from, and the crc that names it.
struct Reference {
  const DepthImage* depth = nullptr;      ///< nullptr: the predicted frame is a key frame
  const LevelPalette* palette = nullptr;  ///< of `depth`; nullptr: it is computed from `depth`
  std::uint32_t crc = 0;
  std::uint16_t since_key = 0;  ///< frames from the key frame to the predicted frame
};

/// Codes `depth` losslessly as a packet, in any mode. Fast ignores `reference`: its frames are all key frames.
[[nodiscard]] WrittenPacket write_frame(const DepthImage& depth, DepthMode mode, const Reference& reference);

/// Codes `depth` losslessly as a packet. `palette`: of `depth`. `mode`: any but Fast.
[[nodiscard]] WrittenPacket write_lossless(const DepthImage& depth, const LevelPalette& palette, DepthMode mode,
                                           const Reference& reference);

/// A packet, and the frame that its decoder reconstructs.
struct CodedFrame {
  WrittenPacket packet;
  DepthImage depth;
  std::optional<LevelPalette> palette = {};  ///< of `depth`; nullopt: not computed
};

/// The samples of the reference frame; empty for a key frame.
[[nodiscard]] std::span<const std::uint16_t> samples_of(const Reference& reference) noexcept;

/// The header of a packet whose body codes `depth` in contexts.
[[nodiscard]] PacketHeader header_of(DepthMode mode, const DepthImage& depth, const Slicing& slicing,
                                     const Reference& reference);

/// A key frame of raw samples, for a frame that coding would not make smaller.
[[nodiscard]] WrittenPacket stored_packet(const DepthImage& depth, DepthMode mode,
                                          const std::optional<DepthWindow>& window = std::nullopt);

/// Codes `depth` near-losslessly: each pixel moves, within its bound, to a depth that costs few bits. `palette`: of
/// `depth`. `reconstruction`: the depths to which pixels may move (codec/bounded/reconstruction.h).
[[nodiscard]] CodedFrame code_bounded(const DepthImage& depth, const LevelPalette& palette,
                                      ReconstructionLevels& reconstruction, const Reference& reference);

struct DecodedFrame {
  DepthImage depth;
  std::optional<LevelPalette> palette;  ///< of `depth`; nullopt: not computed
};

/// Decodes a packet. The decoded samples must match the header's crc.
[[nodiscard]] Result<DecodedFrame> read_frame(const Packet& packet, const Reference& reference);

}  // namespace telepalp::codec
