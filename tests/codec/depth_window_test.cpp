#include "proto/words/depth/depth_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "codec/depth_stream.h"
#include "codec/packet/depth_packet.h"
#include "tests/codec/depth_frames.h"
#include "tests/codec/depth_windows.h"

namespace telepalp::codec {
namespace {

constexpr int kImageWidth_px = 96;
constexpr int kImageHeight_px = 200;

struct WindowCase {
  std::string name;
  PixelRect exact;
};

const std::vector<WindowCase>& window_cases() {
  static const std::vector<WindowCase> cases{
      {"in the middle", {30, 60, 40, 70}},
      {"in the corner at the origin", {0, 0, 40, 70}},
      {"in the other corner", {kImageWidth_px - 40, kImageHeight_px - 70, 40, 70}},
      {"one pixel from the border", {1, 1, kImageWidth_px - 2, kImageHeight_px - 2}},
      {"the whole image", {0, 0, kImageWidth_px, kImageHeight_px}},
      {"one pixel", {50, 100, 1, 1}},
      {"one column", {50, 0, 1, kImageHeight_px}},
      {"one row", {0, 100, kImageWidth_px, 1}}};
  return cases;
}

class DepthWindowMode : public testing::TestWithParam<DepthMode> {};

TEST_P(DepthWindowMode, IsExactInsideAndWithinItsBoundOutside) {
  for (const WindowGrowth growth : {WindowGrowth::Flat, WindowGrowth::Growing})
    for (const WindowCase& window : window_cases()) {
      DepthEncoder encoder({.mode = GetParam(), .key_every = 4});
      DepthReader reader;
      for (unsigned i = 0; i < 6; ++i) {
        DepthImage depth = kinect_like(kImageWidth_px, kImageHeight_px, i, static_cast<int>(3 * i));
        depth.unit_m = growth == WindowGrowth::Flat ? 0.001 : 0.000125;
        const DepthWindow stated = window_around(window.exact, growth);
        const EncodedDepth encoded = encoder.encode(depth, stated);
        EXPECT_EQ(encoded.window, stated);
        EXPECT_EQ(encoded.bound, stated.border);
        const Result<DecodedDepth> back = reader.read(bytes_of(encoded.bytes));
        ASSERT_TRUE(back.ok()) << window.name << ": " << to_string(back.error());
        EXPECT_EQ(back->window, stated) << window.name;
        EXPECT_EQ(back->mode, GetParam());
        expect_within(back->image, depth, stated, window.name);
      }
    }
}

TEST_P(DepthWindowMode, MayMoveFromFrameToFrameAndComeAndGo) {
  DepthEncoder encoder({.mode = GetParam(), .key_every = 12});
  DepthDecoder decoder;
  for (int i = 0; i < 24; ++i) {
    const DepthImage depth = kinect_like(kImageWidth_px, kImageHeight_px, static_cast<unsigned>(i), i);
    std::optional<DepthWindow> window;
    if (i % 5 != 4) window = window_around({2 * i, 5 * i, 20 + i, 30 + 2 * i}, static_cast<WindowGrowth>(i / 3 % 2));
    const Result<DepthImage> back = decoder.decode(bytes_of(encoder.encode(depth, window).bytes));
    ASSERT_TRUE(back.ok()) << i << ": " << to_string(back.error());
    if (window)
      expect_within(*back, depth, *window, i);
    else
      EXPECT_EQ(back->samples, depth.samples) << i;
  }
}

TEST_P(DepthWindowMode, SavesBytes) {
  for (const WindowGrowth growth : {WindowGrowth::Flat, WindowGrowth::Growing}) {
    const DepthWindow window = window_around({120, 90, 80, 60}, growth);
    DepthEncoder without_window({.mode = GetParam()});
    DepthEncoder with_window({.mode = GetParam()});
    std::size_t whole = 0;
    std::size_t part = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const DepthImage depth = kinect_like(320, 240, i, static_cast<int>(i));
      whole += without_window.encode(depth).bytes.size();
      part += with_window.encode(depth, window).bytes.size();
    }
    EXPECT_LT(part, whole * 8 / 10);
  }
}

TEST_P(DepthWindowMode, EveryTruncationIsAnError) {
  DepthEncoder encoder({.mode = GetParam()});
  const std::string packet = encoder.encode(kinect_like(64, 40, 21), some_window()).bytes;
  for (std::size_t size = 0; size < packet.size(); ++size)
    ASSERT_FALSE(decode_depth(bytes_of(packet).first(size)).ok()) << size;
}

TEST_P(DepthWindowMode, EveryFlippedBitIsAnErrorOrTheSameDepthWithTheSameWindow) {
  DepthEncoder encoder({.mode = GetParam()});
  const std::string packet = encoder.encode(kinect_like(64, 40, 22), some_window()).bytes;
  const DepthImage sent = decode_depth(bytes_of(packet)).value();
  for (std::size_t bit = 0; bit < 8 * packet.size(); ++bit) {
    std::string damaged = packet;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    DepthReader reader;
    const Result<DecodedDepth> back = reader.read(bytes_of(damaged));
    if (!back.ok()) continue;
    EXPECT_EQ(back->image.samples, sent.samples) << bit;
    EXPECT_EQ(back->window, some_window()) << bit;
  }
}

INSTANTIATE_TEST_SUITE_P(Both, DepthWindowMode, testing::Values(DepthMode::Intra, DepthMode::Temporal),
                         [](const auto& tested) { return std::string(name(tested.param)); });

TEST(DepthWindow, AfterALostFrameOnlyAKeyFrameIsShown) {
  DepthEncoder encoder({.mode = DepthMode::Temporal, .key_every = 6});
  DepthDecoder decoder;
  for (unsigned i = 0; i < 12; ++i) {
    const std::string packet = encoder.encode(kinect_like(64, 40, i), some_window()).bytes;
    if (i == 2) continue;
    EXPECT_EQ(decoder.decode(bytes_of(packet)).ok(), i < 2 || i >= 6) << i;
  }
}

TEST(DepthWindow, ModesWithoutWindowsIgnoreIt) {
  const DepthImage depth = kinect_like(64, 40, 3);
  for (const DepthMode mode : {DepthMode::Fast, DepthMode::Bounded}) {
    DepthEncoder with({.mode = mode});
    DepthEncoder without({.mode = mode});
    const EncodedDepth encoded = with.encode(depth, some_window());
    EXPECT_EQ(encoded.bytes, without.encode(depth).bytes);
    EXPECT_FALSE(encoded.window.has_value());
  }
}

TEST(DepthWindow, PacketsWithoutAWindowKeepTheOldVersion) {
  DepthEncoder encoder({.mode = DepthMode::Intra});
  EXPECT_EQ(encoder.encode(kinect_like(64, 40, 3)).bytes.substr(0, 4), "TPD3");
  EXPECT_EQ(encoder.encode(kinect_like(64, 40, 3), some_window()).bytes.substr(0, 4), "TPD4");
}

/// A packet with one number of its window replaced, and the old checksum: it must be refused before it is decoded.
std::string restated(std::size_t at, auto value) {
  DepthEncoder encoder({.mode = DepthMode::Intra});
  std::string packet = encoder.encode(kinect_like(64, 40, 3), some_window()).bytes;
  std::memcpy(packet.data() + at, &value, sizeof value);
  return packet;
}

TEST(DepthWindow, ThatNoImageCanHaveIsRefused) {
  const auto u16 = [](int value) { return static_cast<std::uint16_t>(value); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, std::string>> bad{
      {"a column outside the image", restated(32, u16(64))},
      {"a negative column", restated(32, u16(-1))},
      {"a row outside the image", restated(34, u16(40))},
      {"a negative row", restated(34, u16(-4))},
      {"no width", restated(36, u16(0))},
      {"a width beyond the image", restated(36, u16(60))},
      {"a negative width", restated(36, u16(-1))},
      {"no height", restated(38, u16(0))},
      {"a height beyond the image", restated(38, u16(65535))},
      {"a bound that is not a number", restated(40, nan)},
      {"a negative bound", restated(48, -1e-3)},
      {"a bound of two metres", restated(64, 2.0)},
      {"an infinite bound", restated(56, std::numeric_limits<double>::infinity())},
      {"a bound that shrinks towards the border", restated(56, 1e-4)},
      {"a mode without windows: fast", restated(4, std::uint8_t{0})},
      {"a mode without windows: bounded", restated(4, std::uint8_t{3})},
      {"a coding without windows: tokens", restated(5, std::uint8_t{2})}};
  for (const auto& [name, packet] : bad) {
    const Result<Packet> read = read_packet(bytes_of(packet));
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_NE(read.error().what.find("window"), std::string::npos) << name << ": " << read.error().what;
    EXPECT_FALSE(is_key_frame(bytes_of(packet))) << name;
  }
}

TEST(DepthWindow, OfAnotherPlaceInTheImageDoesNotMatchTheChecksum) {
  EXPECT_FALSE(decode_depth(bytes_of(restated(32, static_cast<std::uint16_t>(some_window().exact.column + 1)))).ok());
  EXPECT_FALSE(decode_depth(bytes_of(restated(64, 0.9))).ok());
}

TEST(DepthWindow, ItsBoundGrowsFromTheWindowToTheBorderOnEachSide) {
  const DepthWindow window = window_around({20, 10, 30, 20}, WindowGrowth::Growing);
  const auto least_m = [&](int column, int row) {
    const std::optional<DepthErrorBound> bound = bound_at(window, 100, 60, column, row);
    return bound ? bound->least_m : 0.0;
  };
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 100; ++column)
      ASSERT_EQ(window.exact.contains(column, row), least_m(column, row) == 0.0) << column << ", " << row;
  for (int column = 1; column <= 20; ++column) EXPECT_LE(least_m(column, 15), least_m(column - 1, 15)) << column;
  for (int column = 50; column < 100; ++column) EXPECT_GE(least_m(column, 15), least_m(column - 1, 15)) << column;
  for (const auto& [column, row] : {std::pair{0, 15}, {99, 15}, {25, 0}, {25, 59}, {0, 0}, {99, 59}})
    EXPECT_DOUBLE_EQ(least_m(column, row), 0.004) << column << ", " << row;
  EXPECT_DOUBLE_EQ(least_m(50, 15), 0.002);
}

TEST(DepthWindow, IsClippedToTheImageWhateverAPeerAsks) {
  constexpr int kMost = std::numeric_limits<int>::max();
  constexpr int kLeast = std::numeric_limits<int>::min();
  EXPECT_EQ(clipped({-10, -5, 30, 20}, 100, 60), (PixelRect{0, 0, 20, 15}));
  EXPECT_EQ(clipped({90, 50, kMost, kMost}, 100, 60), (PixelRect{90, 50, 10, 10}));
  EXPECT_EQ(clipped({kLeast, kLeast, kMost, kMost}, 100, 60), std::nullopt);
  EXPECT_EQ(clipped({100, 0, 5, 5}, 100, 60), std::nullopt);
  EXPECT_EQ(clipped({10, 10, -5, 5}, 100, 60), std::nullopt);
  EXPECT_EQ(clipped({10, 10, 0, 5}, 100, 60), std::nullopt);
}

TEST(DepthWindow, KeepOnlyLeavesNothingOutside) {
  DepthImage depth = filled(20, 10, 700);
  const PixelRect exact{3, 2, 5, 4};
  keep_only(depth, exact);
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 20; ++column)
      EXPECT_EQ(depth.at(column, row), exact.contains(column, row) ? 700 : 0) << column << ", " << row;
}

}  // namespace
}  // namespace telepalp::codec
