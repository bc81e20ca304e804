#include "codec/depth.h"

#include <array>

#include "codec/bounded/reconstruction.h"
#include "codec/stream/frame_coding.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

constexpr std::array<std::string_view, kLastDepthMode + 1> kNames{"fast", "intra", "temporal", "bounded"};

}  // namespace

std::string_view name(DepthMode mode) noexcept { return kNames[static_cast<std::size_t>(mode)]; }

std::optional<DepthMode> depth_mode(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<DepthMode>(i);
  return std::nullopt;
}

DepthWindow window_around(const PixelRect& exact, WindowGrowth growth) noexcept {
  const auto times = [](double factor) {
    return DepthErrorBound{.least_m = factor * kOneDisparityStep.least_m, .per_m = factor * kOneDisparityStep.per_m};
  };
  return {.exact = exact, .near = times(2.0), .border = times(growth == WindowGrowth::Flat ? 2.0 : 4.0)};
}

std::string encode_depth(const DepthImage& depth, DepthMode mode) {
  demand(is_well_formed(depth), "encode_depth is given a well-formed image");
  if (mode == DepthMode::Bounded) {
    const LevelPalette palette = palette_of(depth.samples);
    ReconstructionLevels reconstruction = reconstruction_levels_for(depth, palette, kOneDisparityStep);
    return code_bounded(depth, palette, reconstruction, {}).packet.bytes;
  }
  return write_frame(depth, mode, {}).bytes;
}

Result<DepthImage> decode_depth(std::span<const std::byte> bytes) {
  const Result<Packet> packet = read_packet(bytes);
  if (!packet) return packet.error();
  if (packet->header.coding == Coding::Dependent)
    return damaged("it is predicted from the frame before it, and cannot be decoded alone");
  Result<DecodedFrame> frame = read_frame(*packet, {});
  if (!frame) return frame.error();
  return std::move(frame->depth);
}

Result<DepthPacketInfo> inspect_depth(std::span<const std::byte> bytes) {
  constexpr std::array<std::string_view, kLastCoding + 1> kCodings{"stored", "zstd", "tokens", "contexts", "dependent"};
  const Result<Packet> packet = read_packet(bytes);
  if (!packet) return packet.error();
  const PacketHeader& header = packet->header;
  return DepthPacketInfo{.mode = header.mode,
                         .coding = kCodings[static_cast<std::size_t>(header.coding)],
                         .width = header.width,
                         .height = header.height,
                         .unit_m = header.unit_m,
                         .slices = header.slices,
                         .since_key = header.since_key,
                         .window = header.window};
}

}  // namespace telepalp::codec
