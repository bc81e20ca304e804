#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "codec/depth.h"
#include "proto/words/depth/depth_window.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// The largest number of samples in an image. It bounds every allocation made for a packet.
inline constexpr std::size_t kMaxPixels = std::size_t{kMaxImageSide} * kMaxImageSide;

/// The format of a packet's body. The encoder chooses it for each frame. A rank is the index of a pixel's depth in the
/// palette, the list of the frame's distinct depths.
enum class Coding : std::uint8_t {
  Stored = 0,     ///< raw samples, when no other coding is smaller
  Zstd = 1,       ///< raw samples, compressed by zstd
  Tokens = 2,     ///< ranks as run-length tokens, compressed by zstd
  Contexts = 3,   ///< ranks, context-modelled, in slices; a key frame
  Dependent = 4,  ///< as Contexts, with a reference frame as further context
};
inline constexpr std::uint8_t kLastCoding = 4;

/// The header of every packet, 32 bytes:
/// "TPD" | version u8, '3' or '4' | mode u8 | coding u8 | slices u8 | 0 u8 | width u16 | height u16 | crc u32 | unit_m
/// f64 | reference u32 | since_key u16 | 0 u16, little-endian. `crc` is CRC-32C of the other 28 bytes, then of the
/// decoded samples. As it covers the decoded samples, it detects a decoder's wrong reference frame or probability
/// tables, and a flipped bit. A packet of version 4 has a window: 40 more bytes follow, which the crc covers too:
/// column u16 | row u16 | width u16 | height u16 | near least_m f64 | near per_m f64 | border least_m f64 | border
/// per_m f64. Its body is described at codec/stream/window_coding.h.
struct PacketHeader {
  DepthMode mode = DepthMode::Fast;
  Coding coding = Coding::Stored;
  std::uint8_t slices = 1;
  int width = 0;
  int height = 0;
  std::uint32_t crc = 0;
  double unit_m = 0.001;
  std::uint32_t reference = 0;             ///< crc of the reference frame; 0 in a key frame
  std::uint16_t since_key = 0;             ///< frames since the last key frame; 0 in a key frame
  std::optional<DepthWindow> window = {};  ///< of Intra and Temporal; well formed; nullopt: version 3

  [[nodiscard]] std::size_t pixels() const noexcept {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

inline constexpr std::size_t kHeaderBytes = 32;
inline constexpr std::size_t kWindowBytes = 40;

struct Packet {
  PacketHeader header;
  std::span<const std::byte> body;
};

/// A packet as it is sent, with the content of its header.
struct WrittenPacket {
  std::string bytes;
  std::uint32_t crc = 0;
  bool key_frame = true;
};

/// Writes header and body as one packet. The header's crc is computed from `samples`.
[[nodiscard]] WrittenPacket write_packet(PacketHeader header, std::span<const std::uint16_t> samples,
                                         std::string_view body);

/// Parses a packet's header. Error: a field is out of bounds, or the packet has another format version.
[[nodiscard]] Result<Packet> read_packet(std::span<const std::byte> bytes);

/// The crc for `samples` under this header; it does not depend on header.crc.
[[nodiscard]] std::uint32_t frame_crc(const PacketHeader& header, std::span<const std::uint16_t> samples);

/// The error for a damaged packet. `what`: the damage, in words.
[[nodiscard]] Error damaged(std::string what);

}  // namespace telepalp::codec
