#include "tests/bench/depth/depth_asked.h"

#include <algorithm>
#include <span>

#include "codec/bytes/crc32c.h"

namespace telepalp::bench {
namespace {

struct KnownSet {
  std::uint32_t mark;
  RatiosAsked asked;
};

constexpr KnownSet kKnownSets[] = {
    {2289064465U, {"the recorded room of a Kinect v1", {13.5, 18.5, 20.0, 40.0}}},
    {3187811452U, {"the desk of a RealSense D4xx", {0.0, 9.4, 0.0, 0.0}}},
};

}  // namespace

std::uint32_t set_mark(const DepthImage& first) { return codec::crc32c(std::as_bytes(std::span(first.samples))); }

const RatiosAsked* ratios_asked(const DepthImage& first) {
  const std::uint32_t crc = set_mark(first);
  const auto* known = std::find_if(std::begin(kKnownSets), std::end(kKnownSets),
                                   [crc](const KnownSet& set) { return set.mark == crc; });
  return known == std::end(kKnownSets) ? nullptr : &known->asked;
}

}  // namespace telepalp::bench
