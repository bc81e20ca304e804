#include "codec/depth_codec.h"

#include <array>

#include "codec/context_coding.h"
#include "codec/depth_packet.h"
#include "codec/fast_coding.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

constexpr std::array<std::string_view, kLastDepthMode + 1> kNames{"fast", "intra"};

std::string packet_of(const DepthImage& depth, PacketHeader header, std::string_view body) {
  header.width = depth.width;
  header.height = depth.height;
  header.unit_m = depth.unit_m;
  return write_packet(header, depth.samples, body);
}

std::string fast_packet(const DepthImage& depth) {
  const Body body = encode_fast(depth);
  return packet_of(depth, {.mode = DepthMode::Fast, .coding = body.coding}, body.bytes);
}

std::string intra_packet(const DepthImage& depth) {
  const LevelPalette palette = palette_of(depth.samples);
  const Slicing slicing = Slicing::for_frame(depth.width, depth.height);
  const std::optional<std::string> body =
      encode_contexts(ranks_in(palette, depth.samples), depth.width, palette, slicing, context_kernel());
  if (!body) return packet_of(depth, {.mode = DepthMode::Intra, .coding = Coding::Stored}, stored(depth).bytes);
  return packet_of(
      depth,
      {.mode = DepthMode::Intra, .coding = Coding::Contexts, .slices = static_cast<std::uint8_t>(slicing.slices)},
      *body);
}

bool decode_body(const Packet& packet, std::span<std::uint16_t> samples) {
  if (packet.header.coding == Coding::Contexts) return decode_contexts(packet, samples, context_kernel());
  return decode_fast(packet, samples);
}

}  // namespace

std::string_view name(DepthMode mode) noexcept { return kNames[static_cast<std::size_t>(mode)]; }

std::optional<DepthMode> depth_mode(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<DepthMode>(i);
  return std::nullopt;
}

std::string encode_depth(const DepthImage& depth, DepthMode mode) {
  demand(is_well_formed(depth), "encode_depth is given a well-formed image");
  return mode == DepthMode::Fast ? fast_packet(depth) : intra_packet(depth);
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
  if (!decode_body(*packet, depth.samples)) return damaged("coded samples are damaged");
  if (frame_crc(header, depth.samples) != header.crc) return damaged("decoded samples are not those that were sent");
  return depth;
}

}  // namespace telepalp::codec
