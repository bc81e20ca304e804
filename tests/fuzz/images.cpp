#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "codec/depth_stream.h"
#include "proto/words/demand.h"

namespace {

using namespace telepalp;
using namespace telepalp::codec;

constexpr std::size_t kFrames = 3;
constexpr std::size_t kHead = 4;  // the first bytes select mode, unit and window, width, and the bound's two numbers

std::uint16_t sample_at(const std::uint8_t* data, std::size_t index) {
  return static_cast<std::uint16_t>(data[2 * index] | data[2 * index + 1] << 8);
}

/// A window in an image of `width` x `height` pixels, chosen by three bytes of `data`. nullopt: bit 3 of the first byte
/// is not set.
std::optional<DepthWindow> window_of(const std::uint8_t* data, int width, int height) {
  if ((data[0] & 8) == 0) return std::nullopt;
  const PixelRect exact{
      .column = data[2] % width, .row = data[3] % height, .width = 1 + data[3] % width, .height = 1 + data[2] % height};
  return window_around(*clipped(exact, width, height), static_cast<WindowGrowth>(data[0] >> 4 & 1));
}

/// The bound on the error of one pixel; nullopt: the pixel is exact.
std::optional<DepthErrorBound> bound_of(const EncodedDepth& encoded, const DepthImage& image, int column, int row) {
  return encoded.window ? bound_at(*encoded.window, image.width, image.height, column, row) : encoded.bound;
}

void demand_kept(const DepthImage& sent, const DepthImage& got, const EncodedDepth& encoded) {
  demand(got.width == sent.width && got.height == sent.height && got.unit_m == sent.unit_m, "the same frame");
  for (int row = 0; row < sent.height; ++row)
    for (int column = 0; column < sent.width; ++column) {
      const int was = sent.at(column, row);
      const int is = got.at(column, row);
      const std::optional<DepthErrorBound> bound = bound_of(encoded, sent, column, row);
      const double most = bound ? bound->at(was * sent.unit_m) / sent.unit_m + 1e-6 : 0.0;
      demand((was == 0) == (is == 0), "holes stay holes, and depths depths");
      demand(std::abs(is - was) <= most, "no depth beyond its bound");
    }
}

}  // namespace

/// Any three small frames in a stream of any mode: they are decoded unchanged or within their bounds, from packets that
/// are no larger than the samples plus a header.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < kHead + 2 * kFrames) return 0;
  const DepthStreamSettings settings{.mode = static_cast<DepthMode>(data[0] & 3),
                                     .bound = {.least_m = data[2] * 1e-3, .per_m = data[3] * 1e-3}};
  const std::size_t samples = (size - kHead) / 2 / kFrames;
  const std::size_t width = std::min<std::size_t>(samples, std::size_t{1} + data[1]);
  const std::size_t height = std::min<std::size_t>(samples / width, kMaxImageSide);
  DepthEncoder encoder(settings);
  DepthDecoder decoder;
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    DepthImage depth{.width = static_cast<int>(width),
                     .height = static_cast<int>(height),
                     .unit_m = (data[0] & 4) != 0 ? 0.000125 : 0.001,
                     .samples = {}};
    for (std::size_t i = 0; i < width * height; ++i)
      depth.samples.push_back(sample_at(data + kHead, frame * samples + i));
    const EncodedDepth encoded = encoder.encode(depth, window_of(data, depth.width, depth.height));
    demand(encoded.bytes.size() <= 2 * depth.samples.size() + 72, "a packet is never much larger than its frame");
    const Result<DepthImage> back = decoder.decode(std::as_bytes(std::span(encoded.bytes)));
    demand(back.ok(), "what was encoded can be decoded");
    demand_kept(depth, *back, encoded);
  }
  return 0;
}
