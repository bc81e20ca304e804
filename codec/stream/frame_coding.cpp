#include "codec/stream/frame_coding.h"

#include <utility>

#include "codec/fast/fast_coding.h"
#include "codec/stream/window_coding.h"

namespace telepalp::codec {
namespace {

/// Fills the frame. False when the body is damaged.
bool decode_body(const Packet& packet, const Reference& reference, DecodedFrame& frame) {
  const Coding coding = packet.header.coding;
  if (coding != Coding::Contexts && coding != Coding::Dependent) return decode_fast(packet, frame.depth.samples);
  if (packet.header.window) return decode_window(packet, samples_of(reference), frame.depth.samples);
  frame.palette =
      decode_contexts(packet, {samples_of(reference), reference.palette}, frame.depth.samples, context_kernel());
  return frame.palette.has_value();
}

}  // namespace

std::span<const std::uint16_t> samples_of(const Reference& reference) noexcept {
  if (reference.depth == nullptr) return {};
  return reference.depth->samples;
}

PacketHeader header_of(DepthMode mode, const DepthImage& depth, const Slicing& slicing, const Reference& reference) {
  PacketHeader header{.mode = mode,
                      .coding = Coding::Contexts,
                      .slices = static_cast<std::uint8_t>(slicing.slices),
                      .width = depth.width,
                      .height = depth.height,
                      .unit_m = depth.unit_m};
  if (reference.depth == nullptr) return header;
  header.coding = Coding::Dependent;
  header.reference = reference.crc;
  header.since_key = reference.since_key;
  return header;
}

WrittenPacket stored_packet(const DepthImage& depth, DepthMode mode, const std::optional<DepthWindow>& window) {
  const PacketHeader header{.mode = mode,
                            .coding = Coding::Stored,
                            .width = depth.width,
                            .height = depth.height,
                            .unit_m = depth.unit_m,
                            .window = window};
  return write_packet(header, depth.samples, stored(depth).bytes);
}

WrittenPacket write_frame(const DepthImage& depth, DepthMode mode, const Reference& reference) {
  if (mode != DepthMode::Fast) return write_lossless(depth, palette_of(depth.samples), mode, reference);
  const Body body = encode_fast(depth);
  const PacketHeader header{
      .mode = mode, .coding = body.coding, .width = depth.width, .height = depth.height, .unit_m = depth.unit_m};
  return write_packet(header, depth.samples, body.bytes);
}

WrittenPacket write_lossless(const DepthImage& depth, const LevelPalette& palette, DepthMode mode,
                             const Reference& reference) {
  RankedFrame frame = ranked(palette, depth.samples);
  const Slicing slicing = Slicing::for_frame(depth.width, depth.height);
  const std::optional<std::string> body =
      encode_contexts(frame, depth.width, {samples_of(reference), reference.palette}, slicing, context_kernel());
  return body ? write_packet(header_of(mode, depth, slicing, reference), depth.samples, *body)
              : stored_packet(depth, mode);
}

CodedFrame code_bounded(const DepthImage& depth, const LevelPalette& palette, ReconstructionLevels& reconstruction,
                        const Reference& reference) {
  RankedFrame frame = within_bounds(depth, palette, reconstruction);
  const Slicing slicing = Slicing::for_frame(depth.width, depth.height);
  const std::optional<std::string> body =
      encode_contexts(frame, depth.width, {samples_of(reference), reference.palette}, slicing, context_kernel());
  if (!body) return {.packet = stored_packet(depth, DepthMode::Bounded), .depth = depth, .palette = palette};
  DepthImage moved = depth;
  put_levels(frame.ranks, frame.palette, moved.samples);
  WrittenPacket packet = write_packet(header_of(DepthMode::Bounded, depth, slicing, reference), moved.samples, *body);
  return {.packet = std::move(packet), .depth = std::move(moved), .palette = std::move(frame.palette)};
}

Result<DecodedFrame> read_frame(const Packet& packet, const Reference& reference) {
  const PacketHeader& header = packet.header;
  if (header.coding == Coding::Stored && packet.body.size() != header.pixels() * sizeof(std::uint16_t))
    return damaged("it does not hold as many pixels as its header declares");
  DecodedFrame frame{.depth = {.width = header.width,
                               .height = header.height,
                               .unit_m = header.unit_m,
                               .samples = std::vector<std::uint16_t>(header.pixels())},
                     .palette = std::nullopt};
  if (!decode_body(packet, reference, frame)) return damaged("its compressed pixels are damaged");
  if (frame_crc(header, frame.depth.samples) != header.crc)
    return damaged("its decoded pixels do not match its checksum");
  return frame;
}

}  // namespace telepalp::codec
