#include "codec/depth_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "codec/bytes/crc32c.h"
#include "tests/codec/depth_frames.h"

namespace telepalp::codec {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 200;

class LosslessMode : public testing::TestWithParam<DepthMode> {};

TEST_P(LosslessMode, DecodesASequenceUnchanged) {
  DepthEncoder encoder({.mode = GetParam(), .key_every = 4});
  DepthDecoder decoder;
  for (unsigned i = 0; i < 10; ++i) {
    const DepthImage depth = kinect_like(kWidth, kHeight, i, static_cast<int>(i));
    const std::string packet = encoder.encode(depth).bytes;
    const Result<DepthImage> back = decoder.decode(bytes_of(packet));
    ASSERT_TRUE(back.ok()) << to_string(back.error());
    EXPECT_EQ(back->samples, depth.samples);
    EXPECT_EQ(back->unit_m, depth.unit_m);
  }
}

std::string name_of(const testing::TestParamInfo<DepthMode>& tested) { return std::string(name(tested.param)); }

INSTANTIATE_TEST_SUITE_P(All, LosslessMode, testing::Values(DepthMode::Fast, DepthMode::Intra, DepthMode::Temporal),
                         name_of);

TEST(DepthStream, BoundedKeepsItsBoundAndEveryHole) {
  for (const double unit_m : {0.001, 0.000125}) {
    DepthEncoder encoder({.mode = DepthMode::Bounded});
    DepthDecoder decoder;
    for (unsigned i = 0; i < 5; ++i) {
      DepthImage depth = kinect_like(kWidth, kHeight, i, static_cast<int>(3 * i));
      depth.unit_m = unit_m;
      const Result<DepthImage> back = decoder.decode(bytes_of(encoder.encode(depth).bytes));
      ASSERT_TRUE(back.ok());
      for (std::size_t k = 0; k < depth.samples.size(); ++k) {
        ASSERT_EQ(back->samples[k] == 0, depth.samples[k] == 0);
        const double error_m = std::abs(back->samples[k] - depth.samples[k]) * unit_m;
        ASSERT_LE(error_m, kOneDisparityStep.at(depth.samples[k] * unit_m) + 1e-9);
      }
    }
  }
}

TEST(DepthStream, AfterALostFrameOnlyAKeyFrameIsShown) {
  DepthEncoder encoder({.mode = DepthMode::Temporal, .key_every = 6});
  DepthDecoder decoder;
  for (unsigned i = 0; i < 12; ++i) {
    const DepthImage depth = kinect_like(kWidth, kHeight, i);
    const std::string packet = encoder.encode(depth).bytes;
    if (i == 2) continue;  // lost
    const Result<DepthImage> back = decoder.decode(bytes_of(packet));
    EXPECT_EQ(back.ok(), i < 2 || i >= 6) << i;
    if (back.ok()) {
      EXPECT_EQ(back->samples, depth.samples);
    }
  }
}

TEST(DepthStream, WithEverySecondFrameLostOnlyKeyFramesAreShown) {
  DepthEncoder encoder({.mode = DepthMode::Temporal, .key_every = 4});
  DepthDecoder decoder;
  for (unsigned i = 0; i < 12; ++i) {
    const std::string packet = encoder.encode(kinect_like(kWidth, kHeight, i)).bytes;
    if (i % 2 == 0) {
      EXPECT_EQ(decoder.decode(bytes_of(packet)).ok(), i % 4 == 0) << i;
    }
  }
}

TEST(DepthStream, TwoWhoJoinMidGroupSeeFromTheKeyFrameThatIsMadeForThem) {
  DepthEncoder encoder({.mode = DepthMode::Temporal, .key_every = 1000});
  DepthDecoder first;
  DepthDecoder second;
  for (unsigned i = 0; i < 9; ++i) {
    if (i == 6) encoder.request_key_frame();
    const DepthImage depth = kinect_like(kWidth, kHeight, i);
    const std::string packet = encoder.encode(depth).bytes;
    if (i >= 3) {
      EXPECT_EQ(first.decode(bytes_of(packet)).ok(), i >= 6) << i;
    }
    if (i >= 5) {
      EXPECT_EQ(second.decode(bytes_of(packet)).ok(), i >= 6) << i;
    }
  }
}

TEST(DepthStream, AFrameOfAnotherSizeIsAKeyFrame) {
  DepthEncoder encoder({.mode = DepthMode::Temporal});
  DepthDecoder decoder;
  EXPECT_TRUE(decoder.decode(bytes_of(encoder.encode(kinect_like(kWidth, kHeight, 1)).bytes)).ok());
  EXPECT_TRUE(decode_depth(bytes_of(encoder.encode(kinect_like(kHeight, kWidth, 1)).bytes)).ok());
}

TEST(DepthStream, AWrongReferenceIsAnErrorEvenOfTheRightSize) {
  DepthEncoder ours({.mode = DepthMode::Temporal});
  DepthEncoder theirs({.mode = DepthMode::Temporal});
  DepthDecoder decoder;
  ASSERT_TRUE(decoder.decode(bytes_of(theirs.encode(kinect_like(kWidth, kHeight, 7)).bytes)).ok());
  (void)ours.encode(kinect_like(kWidth, kHeight, 1));
  const Result<DepthImage> back = decoder.decode(bytes_of(ours.encode(kinect_like(kWidth, kHeight, 2)).bytes));
  ASSERT_FALSE(back.ok());
  EXPECT_NE(back.error().fix.find("key frame"), std::string::npos);
}

TEST(Crc32c, IsTheOneOfTheStandardBothWays) {
  const std::string_view digits = "123456789";
  EXPECT_EQ(crc32c(std::as_bytes(std::span(digits))), 0xe3069283U);  // RFC 3720, appendix B.4 gives the same polynomial
  std::mt19937 random(3);
  std::string bytes(20000, '\0');  // longer than the stretches that are summed in parallel
  for (char& byte : bytes) byte = static_cast<char>(random());
  for (std::size_t size = 0; size < bytes.size(); size += 377) {
    const auto part = bytes_of(bytes).first(size);
    EXPECT_EQ(crc32c(part), crc32c_by_table(part));
    EXPECT_EQ(crc32c(bytes_of(bytes).subspan(size), crc32c(part)), crc32c(bytes_of(bytes)));
  }
}

}  // namespace
}  // namespace telepalp::codec
