#include "codec/depth_codec.h"

#include <array>

#include "codec/depth_packet.h"
#include "codec/fast_coding.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

constexpr std::array<std::string_view, kLastDepthMode + 1> kNames{"fast"};

}  // namespace

std::string_view name(DepthMode mode) noexcept { return kNames[static_cast<std::size_t>(mode)]; }

std::optional<DepthMode> depth_mode(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<DepthMode>(i);
  return std::nullopt;
}

std::string encode_depth(const DepthImage& depth, DepthMode mode) {
  demand(is_well_formed(depth), "encode_depth is given a well-formed image");
  const Body body = encode_fast(depth);
  return write_packet(
      {.mode = mode, .coding = body.coding, .width = depth.width, .height = depth.height, .unit_m = depth.unit_m},
      depth.samples, body.bytes);
}

Result<DepthImage> decode_depth(std::span<const std::byte> bytes) {
  const Result<Packet> packet = read_packet(bytes);
  if (!packet) return packet.error();
  const PacketHeader& header = packet->header;
  if (header.coding == Coding::Stored && packet->body.size() != header.pixels() * sizeof(std::uint16_t))
    return damaged("stored samples are not as many as the header declares");
  DepthImage depth{.width = header.width,
                   .height = header.height,
                   .unit_m = header.unit_m,
                   .samples = std::vector<std::uint16_t>(header.pixels())};
  if (!decode_fast(*packet, depth.samples)) return damaged("coded samples are damaged");
  if (frame_crc(header, depth.samples) != header.crc) return damaged("decoded samples are not those that were sent");
  return depth;
}

}  // namespace telepalp::codec
