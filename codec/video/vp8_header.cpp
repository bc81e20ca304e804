#include "codec/video/vp8_header.h"

#include <cstdint>
#include <string>
#include <utility>

#include "codec/video.h"

namespace telepalp::codec {
namespace {

constexpr std::size_t kTagBytes = 3;
constexpr std::size_t kKeyHeaderBytes = 10;  // the tag, the start code, width and height
constexpr std::uint32_t kLastVersion = 3;
constexpr std::uint32_t kStartCode = 0x2a019d;
constexpr std::uint32_t kSideMask = 0x3fff;  // the two bits above it ask for a larger display

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t at, std::size_t count) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
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
  const std::uint32_t tag = little_endian(packet, 0, kTagBytes);
  Vp8Header header{.key_frame = (tag & 1) == 0};
  const std::size_t header_bytes = header.key_frame ? kKeyHeaderBytes : kTagBytes;
  if ((tag >> 1 & 7) > kLastVersion) return damaged_video("it is of a version of VP8 that does not exist");
  if ((tag >> 4 & 1) == 0) return damaged_video("it is a frame without a picture");
  if (packet.size() < header_bytes || packet.size() - header_bytes < tag >> 5)
    return damaged_video("the packet is cut short");
  if (!header.key_frame) return header;
  if (little_endian(packet, 3, 3) != kStartCode) return damaged_video("its start code is not one of VP8");
  header.width = static_cast<int>(little_endian(packet, 6, 2) & kSideMask);
  header.height = static_cast<int>(little_endian(packet, 8, 2) & kSideMask);
  if (!is_allowed(header.width, header.height))
    return damaged_video("it declares " + std::to_string(header.width) + " x " + std::to_string(header.height) +
                         " pixels, more than a video frame may have, or none");
  return header;
}

}  // namespace telepalp::codec
