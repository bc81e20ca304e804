#include "codec/context/kernel.h"

#include <gtest/gtest.h>

#include "codec/bounded/reconstruction.h"
#include "codec/context/context_coding.h"
#include "tests/codec/depth_frames.h"

namespace telepalp::codec {
namespace {

/// A frame as ranks, or, if `chooses`, as ranges of ranks within the error bound.
RankedFrame given(const DepthImage& depth, bool chooses) {
  const LevelPalette palette = palette_of(depth.samples);
  if (!chooses) return ranked(palette, depth.samples);
  ReconstructionLevels reconstruction = reconstruction_levels_for(depth, palette, kOneDisparityStep);
  return within_bounds(depth, palette, reconstruction);
}

TEST(ContextKernel, EveryKernelWritesTheSameBytesAndReadsThem) {
  if (v3_context_kernel() == nullptr) GTEST_SKIP() << "this processor runs the portable kernel alone";
  for (const bool chooses : {false, true})
    for (const int height : {1, 3, 171, 200, 497, 512}) {  // 512 rows give four slices of equal height
      const DepthImage before = kinect_like(131, height, 4);
      const DepthImage depth = kinect_like(131, height, 5, 2);
      const RankedFrame frame = given(depth, chooses);
      const Slicing slicing = Slicing::for_frame(131, height);
      for (const FrameBefore& reference : {FrameBefore{}, FrameBefore{before.samples}}) {
        RankedFrame by_plain = frame;
        RankedFrame by_vector = frame;
        const auto plain = encode_contexts(by_plain, 131, reference, slicing, portable_context_kernel());
        const auto vector = encode_contexts(by_vector, 131, reference, slicing, *v3_context_kernel());
        EXPECT_EQ(plain, vector) << height;
        EXPECT_EQ(by_plain.ranks, by_vector.ranks) << height;
        ASSERT_TRUE(plain.has_value());
        for (std::size_t i = 0; chooses && i < frame.ranks.size(); ++i) {
          ASSERT_GE(by_plain.ranks[i], frame.ranks[i]) << i;
          ASSERT_LE(by_plain.ranks[i], frame.most[i]) << i;
          ASSERT_EQ(by_plain.ranks[i] == 0, depth.samples[i] == 0) << i;
        }
        std::vector<std::uint16_t> sent(depth.samples.size());
        put_levels(by_plain.ranks, frame.palette, sent);
        Packet packet{.header = {.slices = static_cast<std::uint8_t>(slicing.slices), .width = 131, .height = height},
                      .body = bytes_of(*plain)};
        for (const ContextKernel* kernel : {&portable_context_kernel(), v3_context_kernel()}) {
          std::vector<std::uint16_t> samples(depth.samples.size());
          EXPECT_EQ(decode_contexts(packet, reference, samples, *kernel).value().levels, frame.palette.levels);
          EXPECT_EQ(samples, sent) << kernel->name;
        }
      }
    }
}

}  // namespace
}  // namespace telepalp::codec
