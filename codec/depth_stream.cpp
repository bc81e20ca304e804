#include "codec/depth_stream.h"

#include <algorithm>
#include <limits>

#include "codec/depth_coding.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

bool alike(const DepthImage& a, const DepthImage& b) noexcept {
  return a.width == b.width && a.height == b.height && a.unit_m == b.unit_m;
}

/// Whether frames of `mode` depend on the one before, but for key frames.
bool makes_groups(DepthMode mode) noexcept { return mode == DepthMode::Temporal || mode == DepthMode::Bounded; }

/// The crc of a frame that we wrote ourselves.
std::uint32_t crc_of(const std::string& packet) {
  const Result<Packet> read = read_packet(std::as_bytes(std::span(packet)));
  demand(read.ok(), "a packet just written can be read");
  return read->header.crc;
}

}  // namespace

std::string DepthEncoder::encode(const DepthImage& depth) {
  demand(is_well_formed(depth), "DepthEncoder is given a well-formed image");
  if (!makes_groups(settings_.mode)) return write_frame(depth, settings_.mode, {});
  constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
  const bool is_key = std::exchange(key_wanted_, false) || !alike(depth, before_) ||
                      since_key_ + 1 >= std::min(settings_.key_every, kMost);
  since_key_ = is_key ? 0 : since_key_ + 1;
  const Reference reference{.depth = is_key ? nullptr : &before_,
                            .palette = is_key ? nullptr : &before_palette_,
                            .crc = before_crc_,
                            .since_key = static_cast<std::uint16_t>(since_key_)};
  WrittenFrame written = write(depth, is_key, reference);
  before_crc_ = crc_of(written.packet);
  before_palette_ = std::move(written.palette);
  before_ = std::move(written.depth);
  return std::move(written.packet);
}

WrittenFrame DepthEncoder::write(const DepthImage& depth, bool is_key, const Reference& reference) {
  LevelPalette palette = palette_of(depth.samples);
  if (settings_.mode == DepthMode::Bounded) {
    if (is_key) stand_ins_ = stand_ins_for(depth, palette, settings_.bound);
    return write_bounded(depth, palette, stand_ins_, reference);
  }
  std::string packet = write_frame(depth, palette, settings_.mode, reference);
  return {.packet = std::move(packet), .depth = depth, .palette = std::move(palette)};
}

Result<DepthImage> DepthDecoder::decode(std::span<const std::byte> bytes) {
  const Result<Packet> packet = read_packet(bytes);
  if (!packet) return packet.error();
  const PacketHeader& header = packet->header;
  Reference reference;
  if (header.coding == Coding::Dependent) {
    const bool at_hand = before_crc_ == header.reference && before_.width == header.width &&
                         before_.height == header.height && !before_.samples.empty();
    if (!at_hand)
      return Error{
          .what = "frame " + std::to_string(header.since_key) + " after a key frame depends on one that is not at hand",
          .where = "DepthDecoder",
          .fix = "wait for the next key frame, or ask for one"};
    reference.depth = &before_;
    if (before_palette_) reference.palette = &*before_palette_;
  }
  Result<DecodedFrame> frame = read_frame(*packet, reference);
  if (!frame) return frame.error();
  if (!makes_groups(header.mode)) return std::move(frame->depth);  // none depends on it: it need not be copied
  before_ = frame->depth;
  before_palette_ = std::move(frame->palette);
  before_crc_ = header.crc;
  return std::move(frame->depth);
}

}  // namespace telepalp::codec
