#include "haptic_station/station/bill/body_stream.h"

#include <span>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"

namespace telepalp::station {
namespace {

msg::DepthImage message_of(const DepthImage& depth, const codec::EncodedDepth& encoded, SessionTime captured,
                           std::size_t number) {
  msg::DepthImage message;
  message.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(captured)));
  message.set_encoded_ns(message.captured_ns());
  message.set_sequence(number);
  message.set_width(static_cast<std::uint32_t>(depth.width));
  message.set_height(static_cast<std::uint32_t>(depth.height));
  message.set_unit_m(depth.unit_m);
  message.set_format(std::string(codec::name(encoded.mode)));
  message.set_data(encoded.bytes.data(), encoded.bytes.size());
  return message;
}

}  // namespace

BodyStream::BodyStream(const SeenBody& body, double seconds) : camera(body.camera()) {
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Fast});
  const auto count = static_cast<std::size_t>(seconds * SeenBody::kFrames_per_s);
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = static_cast<double>(i) / SeenBody::kFrames_per_s;
    const SessionTime captured = kBegin + from_seconds(time_s);
    const DepthImage depth = body.depth_at(time_s);
    const codec::EncodedDepth encoded = encoder.encode(depth);
    images.push_back(
        wire::make_message(wire::kCameraDepth, captured, message_of(depth, encoded, captured, i), encoded.key_frame));
  }
}

}  // namespace telepalp::station
