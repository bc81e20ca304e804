#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "codec/depth_stream.h"
#include "tests/codec/depth_frames.h"
#include "tests/codec/depth_windows.h"

namespace telepalp::codec {
namespace {

/// A frame that is hard to code. The requirement is the same for all, in every mode: the decoded frame is unchanged,
/// or, in Bounded, each pixel is within its bound and each hole stays a hole; the packet is no larger than the samples
/// plus a header.
struct DepthCase {
  std::string name;
  std::string why;
  DepthImage depth;
};

DepthImage painted(int width, int height, auto sample_at) {
  DepthImage depth = filled(width, height, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      depth.samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
          static_cast<std::uint16_t>(sample_at(x, y));
  return depth;
}

std::vector<DepthCase> hard_cases() {
  DepthImage one_pixel = filled(64, 48, 0);
  one_pixel.samples[1000] = 700;
  return {
      {"every pixel invalid", "the palette is empty, and no prediction has a measured neighbour", filled(640, 480, 0)},
      {"one valid pixel", "palette and models cost more than the frame", one_pixel},
      {"every pixel 65535", "rank and depth at the end of their range", filled(640, 480, 65535)},
      {"checkerboard of validity", "every neighbour of a depth is a hole, filled with a prediction",
       painted(640, 480, [](int x, int y) { return (x + y) % 2 == 0 ? 900 : 0; })},
      {"one pixel in all, measured", "no neighbours, and one slice of one row", filled(1, 1, 700)},
      {"one pixel in all, not measured", "there is no depth to code", filled(1, 1, 0)},
      {"one column", "each pixel is the first and the last of its row",
       painted(1, 500, [](int, int y) { return 500 + y / 3; })},
      {"one row", "one slice, and no row above", painted(500, 1, [](int x, int) { return 500 + x / 3; })},
      {"odd sides", "the last slice is shorter, and rows end within a vector", kinect_like(641, 479, 11)},
      {"noise", "no prediction is right: every coding is larger than the samples, and there are 65 536 levels",
       noise(640, 480, 12)},
      {"noise of one odd column", "the same, without horizontal neighbours", noise(1, 4096, 13)},
      {"5000 levels", "ten times as many as a Kinect has",
       painted(640, 480, [](int x, int y) { return 1 + (x * 7 + y * 11) % 5000; })},
      {"40000 levels", "the palette alone is a tenth of the samples",
       painted(640, 480, [](int x, int y) { return 1 + (x * 97 + y * 89) % 40000; })},
      {"every sample there is", "each has a bound of its own",
       painted(256, 256, [](int x, int y) { return x + 256 * y; })},
      {"far values among near ones", "steps of tens of thousands, and bounds of metres next to millimetres",
       painted(640, 480, [](int x, int y) { return x % 37 == 0 ? 65535 - y : 800 + x; })},
      {"levels just out of each other's bound",
       "none can stand for another, and each for both of its neighbours' middle",
       painted(640, 480, [](int x, int y) { return 1000 + 3 * ((x / 5 + y / 7) % 60); })},
      {"smooth, 0.125 mm", "each pixel has a level of its own",
       painted(640, 480, [](int x, int y) { return 6000 + x * x / 50 + y * y / 70; })},
      {"stripes that leave the range of a prediction", "west and north minus north-west is below 0 and above 65535",
       painted(640, 480, [](int x, int y) { return (x / 2 + y / 2) % 2 == 0 ? 1 : 65535; })},
      {"the largest side", "rows of the greatest allowed length", painted(4096, 2, [](int x, int) { return x; })},
  };
}

std::ostream& operator<<(std::ostream& out, const DepthCase& hard) { return out << hard.name << ": " << hard.why; }

/// Fails unless each pixel is unchanged, or, in Bounded, within the default bound.
void expect_kept(const DepthImage& back, const DepthImage& depth, DepthMode mode, const auto& name) {
  ASSERT_EQ(back.samples.size(), depth.samples.size()) << name;
  if (mode != DepthMode::Bounded) {
    EXPECT_EQ(back.samples, depth.samples) << name;
    return;
  }
  for (std::size_t i = 0; i < depth.samples.size(); ++i) {
    ASSERT_EQ(back.samples[i] == 0, depth.samples[i] == 0) << name << ", pixel " << i;
    const double error_m = std::abs(back.samples[i] - depth.samples[i]) * depth.unit_m;
    ASSERT_LE(error_m, kOneDisparityStep.at(depth.samples[i] * depth.unit_m) + 1e-9) << name << ", pixel " << i;
  }
}

class DepthHardCase : public testing::TestWithParam<DepthMode> {};

TEST_P(DepthHardCase, ComesBackWithinItsBoundAndNeverMuchLargerThanRaw) {
  for (const DepthCase& hard : hard_cases()) {
    const std::string packet = encode_depth(hard.depth, GetParam());
    EXPECT_LE(packet.size(), hard.depth.samples.size() * 2 + 64) << hard;
    const Result<DepthImage> back = decode_depth(bytes_of(packet));
    ASSERT_TRUE(back.ok()) << hard << ": " << to_string(back.error());
    expect_kept(*back, hard.depth, GetParam(), hard);
  }
}

TEST_P(DepthHardCase, MayFollowAnyOtherInOneStream) {
  DepthEncoder encoder({.mode = GetParam()});
  DepthDecoder decoder;
  for (int round = 0; round < 2; ++round)
    for (const DepthCase& hard : hard_cases()) {
      const std::string packet = encoder.encode(hard.depth).bytes;
      EXPECT_LE(packet.size(), hard.depth.samples.size() * 2 + 64) << hard;
      const Result<DepthImage> back = decoder.decode(bytes_of(packet));
      ASSERT_TRUE(back.ok()) << hard << ": " << to_string(back.error());
      expect_kept(*back, hard.depth, GetParam(), hard);
    }
}

/// A window in the middle third of an image, or all of an image that is smaller than that.
DepthWindow middle_of(const DepthImage& depth, WindowGrowth growth) {
  const int width = std::max(1, depth.width / 3);
  const int height = std::max(1, depth.height / 3);
  return window_around({(depth.width - width) / 2, (depth.height - height) / 2, width, height}, growth);
}

TEST(DepthWindowHardCase, IsExactInTheWindowAndWithinItsBoundAroundIt) {
  for (const DepthMode mode : {DepthMode::Intra, DepthMode::Temporal}) {
    DepthEncoder encoder({.mode = mode});
    DepthDecoder decoder;
    for (const WindowGrowth growth : {WindowGrowth::Flat, WindowGrowth::Growing, WindowGrowth::Flat})
      for (const DepthCase& hard : hard_cases()) {
        const DepthWindow window = middle_of(hard.depth, growth);
        const std::string packet = encoder.encode(hard.depth, window).bytes;
        EXPECT_LE(packet.size(), hard.depth.samples.size() * 2 + 72) << hard;
        const Result<DepthImage> back = decoder.decode(bytes_of(packet));
        ASSERT_TRUE(back.ok()) << hard << ": " << to_string(back.error());
        expect_within(*back, hard.depth, window, hard);
      }
  }
}

TEST_P(DepthHardCase, ASetOfLevelsThatChangesEachFrameIsCarried) {
  DepthEncoder encoder({.mode = GetParam()});
  DepthDecoder decoder;
  for (int i = 0; i < 6; ++i) {
    const DepthImage depth = painted(160, 120, [&](int x, int y) { return 1 + (x + y) * (2 + i % 3) + 50 * i; });
    const Result<DepthImage> back = decoder.decode(bytes_of(encoder.encode(depth).bytes));
    ASSERT_TRUE(back.ok());
    expect_kept(*back, depth, GetParam(), i);
  }
}

TEST_P(DepthHardCase, EveryTruncationIsAnError) {
  const std::string packet = encode_depth(kinect_like(64, 40, 21), GetParam());
  for (std::size_t size = 0; size < packet.size(); ++size)
    ASSERT_FALSE(decode_depth(bytes_of(packet).first(size)).ok()) << size;
}

TEST_P(DepthHardCase, EveryFlippedBitIsAnErrorOrTheSameDepth) {
  const DepthImage depth = kinect_like(64, 40, 22);
  const std::string packet = encode_depth(depth, GetParam());
  const Result<DepthImage> sent = decode_depth(bytes_of(packet));
  ASSERT_TRUE(sent.ok());
  for (std::size_t bit = 0; bit < 8 * packet.size(); ++bit) {
    std::string damaged = packet;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    const Result<DepthImage> back = decode_depth(bytes_of(damaged));
    if (!back.ok()) continue;
    EXPECT_EQ(back->samples, sent->samples) << bit;
    EXPECT_EQ(back->unit_m, sent->unit_m) << bit;
    EXPECT_EQ(back->width, sent->width) << bit;
  }
}

TEST_P(DepthHardCase, LiesInTheHeaderAreErrors) {
  const std::string packet = encode_depth(kinect_like(64, 40, 23), GetParam());
  std::mt19937 random(24);
  for (int round = 0; round < 3000; ++round) {
    std::string lying = packet;
    const std::size_t at = 3 + random() % 29;
    lying[at] = static_cast<char>(random());
    if (lying != packet) {
      EXPECT_FALSE(decode_depth(bytes_of(lying)).ok()) << at;
    }
  }
}

TEST(DepthHardCase, AnotherVersionIsNamed) {
  std::string packet = encode_depth(filled(4, 4, 700));
  packet[3] = '2';
  const Result<DepthImage> back = decode_depth(bytes_of(packet));
  ASSERT_FALSE(back.ok());
  EXPECT_NE(back.error().what.find("version 2"), std::string::npos);
}

std::string name_of(const testing::TestParamInfo<DepthMode>& tested) { return std::string(name(tested.param)); }

INSTANTIATE_TEST_SUITE_P(All, DepthHardCase,
                         testing::Values(DepthMode::Fast, DepthMode::Intra, DepthMode::Temporal, DepthMode::Bounded),
                         name_of);

}  // namespace
}  // namespace telepalp::codec
