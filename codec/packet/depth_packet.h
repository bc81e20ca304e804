#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "codec/depth.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// Largest image in samples; every allocation made for a packet is bounded by it.
inline constexpr std::size_t kMaxPixels = std::size_t{kMaxImageSide} * kMaxImageSide;

/// How a packet's body is written. Which one a mode uses is the encoder's choice, frame by frame.
enum class Coding : std::uint8_t {
  Stored = 0,     ///< the samples as they are: nothing else came out smaller
  Zstd = 1,       ///< the samples as they are, through zstd
  Tokens = 2,     ///< ranks, runs of right predictions as tokens, through zstd
  Contexts = 3,   ///< ranks, context-modelled, in slices
  Dependent = 4,  ///< as Contexts, with the frame before as further context
};
inline constexpr std::uint8_t kLastCoding = 4;

/// The fixed front of every packet, 32 bytes:
/// "TPD3" | mode u8 | coding u8 | slices u8 | 0 u8 | width u16 | height u16 | crc u32 | unit_m f64 | reference u32 |
/// since_key u16 | 0 u16, little-endian. `crc` is CRC-32C of these bytes without itself, then of the decoded samples.
/// Why over the decoded samples: a wrong table or a wrong reference is found as surely as a flipped bit.
struct PacketHeader {
  DepthMode mode = DepthMode::Fast;
  Coding coding = Coding::Stored;
  std::uint8_t slices = 1;
  int width = 0;
  int height = 0;
  std::uint32_t crc = 0;
  double unit_m = 0.001;
  std::uint32_t reference = 0;  ///< crc of the frame this one depends on; 0 when it stands alone
  std::uint16_t since_key = 0;  ///< frames since the key frame; 0 is a key frame

  [[nodiscard]] std::size_t pixels() const noexcept {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

inline constexpr std::size_t kHeaderBytes = 32;

struct Packet {
  PacketHeader header;
  std::span<const std::byte> body;
};

/// A packet as it is sent, with what its header says.
struct WrittenPacket {
  std::string bytes;
  std::uint32_t crc = 0;
  bool key_frame = true;
};

/// Writes header and body as one packet. The header's crc is computed from `samples`.
[[nodiscard]] WrittenPacket write_packet(PacketHeader header, std::span<const std::uint16_t> samples,
                                         std::string_view body);

/// Splits a packet; an error unless every field lies within bounds and the version is ours.
[[nodiscard]] Result<Packet> read_packet(std::span<const std::byte> bytes);

/// What `crc` must be for `samples` under this header.
[[nodiscard]] std::uint32_t frame_crc(const PacketHeader& header, std::span<const std::uint16_t> samples);

/// The error for a packet that cannot be trusted.
[[nodiscard]] Error damaged(std::string what);

}  // namespace telepalp::codec
