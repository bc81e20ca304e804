#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "codec/depth_stream.h"
#include "proto/words/demand.h"

namespace {

using namespace telepalp;
using namespace telepalp::codec;

constexpr std::size_t kFrames = 3;
constexpr std::size_t kHead = 4;  // the first bytes select mode and unit, width, and the bound's two numbers

std::uint16_t sample_at(const std::uint8_t* data, std::size_t index) {
  return static_cast<std::uint16_t>(data[2 * index] | data[2 * index + 1] << 8);
}

/// Largest allowed change of a sample, in units.
double most_moved(const DepthStreamSettings& settings, int sample, double unit_m) {
  return settings.mode == DepthMode::Bounded ? settings.bound.at(sample * unit_m) / unit_m + 1e-6 : 0.0;
}

void demand_kept(const DepthImage& sent, const DepthImage& got, const DepthStreamSettings& settings) {
  demand(got.width == sent.width && got.height == sent.height && got.unit_m == sent.unit_m, "the same frame");
  for (std::size_t i = 0; i < sent.samples.size(); ++i) {
    const int was = sent.samples[i];
    const int is = got.samples[i];
    demand((was == 0) == (is == 0), "holes stay holes, and depths depths");
    demand(std::abs(is - was) <= most_moved(settings, was, sent.unit_m), "no depth beyond its bound");
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
    const std::string packet = encoder.encode(depth).bytes;
    demand(packet.size() <= 2 * depth.samples.size() + 64, "a packet is never much larger than its frame");
    const Result<DepthImage> back = decoder.decode(std::as_bytes(std::span(packet)));
    demand(back.ok(), "what was encoded can be decoded");
    demand_kept(depth, *back, settings);
  }
  return 0;
}
