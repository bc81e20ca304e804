#include <cstdint>

#include "codec/context/context_coding.h"
#include "codec/depth_stream.h"
#include "codec/stream/frame_coding.h"
#include "codec/stream/window_coding.h"
#include "proto/words/demand.h"

namespace {

using namespace telepalp;
using namespace telepalp::codec;

constexpr std::size_t kMostPixels = 1 << 16;  // larger images find no other errors and are slower

/// A reference frame for dependent packets, whatever reference they state.
DepthImage some_frame(int width, int height) {
  DepthImage depth{.width = width, .height = height, .unit_m = 0.001, .samples = {}};
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < pixels; ++i)
    depth.samples.push_back(static_cast<std::uint16_t>(i % 97 == 0 ? 0 : 500 + i % 61));
  return depth;
}

}  // namespace

/// Any bytes as a depth packet give an error or a whole frame, and without a window both kernels give the same result.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  const Result<Packet> packet = read_packet(bytes);
  if (!packet || packet->header.pixels() > kMostPixels) return 0;
  const PacketHeader& header = packet->header;
  DepthDecoder decoder;
  const Result<DepthImage> depth = decoder.decode(bytes);
  if (depth) {
    demand(is_well_formed(*depth), "what is decoded is a whole frame");
    demand(frame_crc(header, depth->samples) == header.crc, "what is decoded is what was sent");
  }
  if (header.coding != Coding::Contexts && header.coding != Coding::Dependent) return 0;
  const DepthImage before = some_frame(header.width, header.height);
  const FrameBefore reference = header.coding == Coding::Dependent ? FrameBefore{before.samples} : FrameBefore{};
  std::vector<std::uint16_t> plain(header.pixels());
  if (header.window) {
    (void)decode_window(*packet, reference.samples, plain);
    return 0;
  }
  const bool plain_done = decode_contexts(*packet, reference, plain, portable_context_kernel()).has_value();
  if (v3_context_kernel() == nullptr) return 0;
  std::vector<std::uint16_t> vector(header.pixels());
  const bool vector_done = decode_contexts(*packet, reference, vector, *v3_context_kernel()).has_value();
  demand(plain_done == vector_done && (!plain_done || plain == vector), "kernels agree, on damaged packets too");
  return 0;
}
