#include "codec/video/vp8_header.h"

#include <cstdint>
#include <string>
#include <utility>

#include "codec/video.h"
#include "proto/words/little_endian.h"

namespace telepalp::codec {
namespace {

constexpr std::size_t kTagBytes = 3;
constexpr std::size_t kKeyHeaderBytes = 10;  // the tag, the start code, width and height
constexpr std::uint32_t kLastVersion = 3;
constexpr std::uint32_t kStartCode = 0x2a019d;
constexpr int kSideMask = 0x3fff;  // the two bits above a side ask for a scaled display

/// The three bytes from `at` on, little-endian.
std::uint32_t three_bytes(const std::byte* at) noexcept {
  return std::to_integer<std::uint32_t>(at[0]) | std::uint32_t{get_little_endian<std::uint16_t>(at + 1)} << 8;
}

bool is_allowed(int width, int height) noexcept {
  return width >= 1 && height >= 1 && width <= kMaxImageSide && height <= kMaxImageSide &&
         static_cast<std::size_t>(width) * static_cast<std::size_t>(height) <= kMaxVideoPixels;
}

}  // namespace

Error damaged_video(std::string what) {
  return {.what = std::move(what), .where = "colour video", .fix = "wait for the next key frame"};
}

Result<Vp8Header> read_vp8_header(std::span<const std::byte> packet) {
  if (packet.size() > kMaxVideoPacketBytes)
    return damaged_video("a packet of " + std::to_string(packet.size()) + " B is larger than the " +
                         std::to_string(kMaxVideoPacketBytes) + " B that are allowed");
  if (packet.size() < kTagBytes) return damaged_video("the packet is shorter than a frame's header");
  const std::uint32_t tag = three_bytes(packet.data());
  Vp8Header header{.key_frame = (tag & 1) == 0};
  const std::size_t header_bytes = header.key_frame ? kKeyHeaderBytes : kTagBytes;
  if ((tag >> 1 & 7) > kLastVersion) return damaged_video("it is of a version of VP8 that does not exist");
  if ((tag >> 4 & 1) == 0) return damaged_video("it is a frame without a picture");
  if (packet.size() < header_bytes || packet.size() - header_bytes < tag >> 5)
    return damaged_video("the packet is cut short");
  if (!header.key_frame) return header;
  if (three_bytes(&packet[kTagBytes]) != kStartCode) return damaged_video("its start code is not one of VP8");
  header.width = get_little_endian<std::uint16_t>(&packet[6]) & kSideMask;
  header.height = get_little_endian<std::uint16_t>(&packet[8]) & kSideMask;
  if (!is_allowed(header.width, header.height))
    return damaged_video(
        "it declares " + std::to_string(header.width) + " x " + std::to_string(header.height) +
        " pixels; a video frame has at least 1 x 1 pixel, and at most 4096 a side and 4096 x 2160 in all");
  return header;
}

}  // namespace telepalp::codec
