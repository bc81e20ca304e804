#include "codec/stream/packet_decoder.h"

#include <utility>

namespace telepalp::codec {

bool PacketDecoder::has_reference_of(const PacketHeader& header) const noexcept {
  return previous_crc_ == header.reference && previous_.width == header.width && previous_.height == header.height &&
         !previous_.samples.empty();
}

Reference PacketDecoder::reference() const noexcept {
  Reference reference{.depth = &previous_};
  if (previous_palette_) reference.palette = &*previous_palette_;
  return reference;
}

Result<DepthImage> PacketDecoder::decode(const Packet& packet) {
  const PacketHeader& header = packet.header;
  const bool is_key = header.coding != Coding::Dependent;
  if (!is_key && !has_reference_of(header))
    return Error{
        .what = "it is frame " + std::to_string(header.since_key) +
                " after a key frame, and the frame that it is predicted from was not received",
        .where = "compressed depth image",
        .fix = "in a live stream, wait for the next key frame; in a recording, use the images from that key frame on"};
  Result<DecodedFrame> frame = read_frame(packet, is_key ? Reference{} : reference());
  if (!frame) return frame.error();
  if (!is_predictive(header.mode))
    return std::move(frame->depth);  // such a frame is never a reference, so it is not copied
  previous_ = frame->depth;
  previous_palette_ = std::move(frame->palette);
  previous_crc_ = header.crc;
  return std::move(frame->depth);
}

}  // namespace telepalp::codec
